// Scenes over the portions of one mesh, each in a thread of this process, that exchange through memory.
#pragma once

#include <arenite/arenite.hpp>
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace arenite::test {

/// Where the scenes wait for each other. Throws `run_error` in all who wait once one has failed.
class Meeting {
 public:
  explicit Meeting(std::size_t count) : count_{count} {}
  void wait() {
    std::unique_lock lock(mutex_);
    const std::size_t round = round_;
    if (++here_ == count_) {
      here_ = 0;
      ++round_;
      all_.notify_all();
    }
    all_.wait(lock, [&] { return round != round_ || !failure_.empty(); });
    if (round == round_) throw run_error("another portion failed: " + failure_);
  }
  void fail(const std::string& what) {
    const std::lock_guard lock(mutex_);
    if (failure_.empty()) failure_ = what;
    all_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable all_;
  std::size_t count_, here_ = 0, round_ = 0;
  std::string failure_;
};

/// What the scenes lay on the table for each other.
template <int D>
struct Table {
  explicit Table(const std::vector<MeshPortion<D>>& all)
      : portions{all}, meeting(all.size()), numbers(all.size()), messages(all.size()) {
    std::map<std::uint64_t, std::vector<std::pair<std::size_t, Index>>> copies;
    for (std::size_t s = 0; s < all.size(); ++s)
      for (Index i = 0; i < all[s].whole_node.size(); ++i) copies[all[s].whole_node[i]].push_back({s, i});
    for (const auto& [node, places] : copies)
      if (places.size() > 1) shared.push_back(places);
  }
  std::vector<MeshPortion<D>> portions;
  Meeting meeting;
  std::vector<std::vector<std::pair<std::size_t, Index>>> shared;  // the copies of each shared node, by scene
  std::vector<std::vector<double>> numbers;                        // [scenes]
  std::vector<Messages> messages;                                  // [from][to]
  std::atomic<std::size_t> bytes = 0;                              // of all messages so far
};

/// The communicator of one of the scenes. Sums are taken in the order of the scenes.
template <int D>
class Joined {
 public:
  static constexpr bool is_serial = false;
  Joined(Table<D>& table, std::size_t number) : table_{&table}, number_{number} {}

  void sum_nodes(std::span<double> values, std::size_t count) const {
    lay_out(values);
    for (const auto& copies : table_->shared)
      for (const auto& [s, i] : copies) {
        if (s != number_) continue;
        for (std::size_t k = 0; k < count; ++k) {
          double total = 0;
          for (const auto& [t, j] : copies) total += table_->numbers[t][j * count + k];
          values[i * count + k] = total;
        }
      }
    table_->meeting.wait();
  }
  void share_nodes(std::span<double> values, std::size_t count) const {
    lay_out(values);
    for (const auto& copies : table_->shared)
      for (const auto& [s, i] : copies) {
        if (s != number_) continue;
        for (const auto& [t, j] : copies)
          if (static_cast<int>(t) == table_->portions[s].node_owner[i])
            for (std::size_t k = 0; k < count; ++k) values[i * count + k] = table_->numbers[t][j * count + k];
      }
    table_->meeting.wait();
  }
  void sum(std::span<double> values) const {
    lay_out(values);
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = 0;
      for (const auto& numbers : table_->numbers) values[k] += numbers[k];
    }
    table_->meeting.wait();
  }
  double least(double value) const {
    lay_out(std::span(&value, 1));
    for (const auto& numbers : table_->numbers) value = std::min(value, numbers[0]);
    table_->meeting.wait();
    return value;
  }
  bool first() const { return number_ == 0; }
  std::size_t size() const { return table_->portions.size(); }
  void fail(const std::string& what) const { table_->meeting.fail(what); }
  Messages exchange(Messages to) const {
    for (const auto& message : to) table_->bytes += message.size();
    table_->messages[number_] = std::move(to);
    table_->meeting.wait();
    Messages from;
    for (const auto& messages : table_->messages) from.push_back(messages[number_]);
    table_->meeting.wait();
    return from;
  }

 private:
  void lay_out(std::span<const double> values) const {
    table_->numbers[number_].assign(values.begin(), values.end());
    table_->meeting.wait();
  }
  Table<D>* table_;
  std::size_t number_;
};

}  // namespace arenite::test
