// Stop signals: SIGINT and SIGTERM end a run between two steps instead of at once. POSIX.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>
#include <exception>
#include <string>

#include <arenite/run/run_flow.hpp>

namespace arenite {  // one for all instruction sets, as all exceptions

/// Why a run ended between two steps: a signal asked for it.
class Interruption : public std::exception {
 public:
  explicit Interruption(int signal)
      : signal_{signal}, text_{signal == SIGINT ? "interrupted by SIGINT" : "interrupted by SIGTERM"} {}
  const char* what() const noexcept override { return text_.c_str(); }
  /// As a shell counts the end by a signal: 130 for SIGINT, 143 for SIGTERM.
  int exit_code() const { return 128 + signal_; }

 private:
  int signal_;
  std::string text_;
};

}  // namespace arenite

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// While one exists, the first SIGINT or SIGTERM is noted; a second one of its kind ends the program as
/// usual. A signal that was ignored (nohup, a job in the background) stays ignored. As an observer it ends a
/// run after the step in which a signal came; a program that wants an exception calls `check`. One at a time.
class StopSignals {
 public:
  StopSignals() {
    noted_ = 0;
    struct sigaction note {};
    note.sa_handler = [](int signal) { noted_ = signal; };
    note.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    for (int k = 0; k < 2; ++k) {
      ::sigaction(signals_[k], nullptr, &before_[k]);
      if (before_[k].sa_handler != SIG_IGN) ::sigaction(signals_[k], &note, nullptr);
    }
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals() {
    for (int k = 0; k < 2; ++k) ::sigaction(signals_[k], &before_[k], nullptr);
  }

  bool has_come() const { return noted_ != 0; }
  /// Throws `Interruption` once a signal has come.
  void check() const {
    if (noted_ != 0) throw Interruption(noted_);
  }
  template <class Scene>
  RunFlow operator()(const Scene&) const {
    return has_come() ? RunFlow::stop : RunFlow::go_on;
  }

 private:
  static constexpr int signals_[2] = {SIGINT, SIGTERM};
  static inline volatile std::sig_atomic_t noted_ = 0;
  struct sigaction before_[2]{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
