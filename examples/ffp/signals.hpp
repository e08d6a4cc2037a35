// Signals: SIGINT and SIGTERM end a run between two steps instead of at once. POSIX.
#pragma once

#include <csignal>
#include <exception>
#include <string>

namespace arenite::ffp {

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

/// While one lives, the first SIGINT or SIGTERM is noted, for `check` to find; a second one of its kind ends
/// the program as ever. A signal that was ignored (nohup, a job in the background) stays ignored.
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

 private:
  static constexpr int signals_[2] = {SIGINT, SIGTERM};
  static inline volatile std::sig_atomic_t noted_ = 0;
  struct sigaction before_[2]{};
};

}  // namespace arenite::ffp
