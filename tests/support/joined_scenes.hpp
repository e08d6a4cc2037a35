// Scenes over the portions of one mesh, each in a thread of this process, that exchange through memory.
#pragma once

#include <arenite/arenite.hpp>
#include <arenite/scene/migrate.hpp>
#include <condition_variable>
#include <functional>
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
template <class Scene>
struct Table {
  explicit Table(const std::vector<MeshPortion<Scene::D>>& all)
      : portions{all}, meeting(all.size()), numbers(all.size()), arrivals(all.size()) {
    std::map<std::uint64_t, std::vector<std::pair<std::size_t, Index>>> copies;
    for (std::size_t s = 0; s < all.size(); ++s)
      for (Index i = 0; i < all[s].whole_node.size(); ++i) copies[all[s].whole_node[i]].push_back({s, i});
    for (const auto& [node, places] : copies)
      if (places.size() > 1) shared.push_back(places);
  }
  std::vector<MeshPortion<Scene::D>> portions;
  Meeting meeting;
  std::vector<std::vector<std::pair<std::size_t, Index>>> shared;  // the copies of each shared node, by scene
  std::vector<std::vector<double>> numbers;                        // [scenes]
  std::vector<std::vector<std::vector<std::function<void(Scene&)>>>> arrivals;  // [from][to]
};

/// The exchange of one of the scenes. Sums are taken in the order of the scenes.
template <class Scene>
class Joined {
 public:
  static constexpr bool is_serial = false;
  Joined(Table<Scene>& table, std::size_t number) : table_{table}, number_{number} {}

  void sum_nodes(std::span<double> values, std::size_t count) {
    lay_out(values);
    for (const auto& copies : table_.shared)
      for (const auto& [s, i] : copies) {
        if (s != number_) continue;
        for (std::size_t k = 0; k < count; ++k) {
          double total = 0;
          for (const auto& [t, j] : copies) total += table_.numbers[t][j * count + k];
          values[i * count + k] = total;
        }
      }
    table_.meeting.wait();
  }
  void share_nodes(std::span<double> values, std::size_t count) {
    lay_out(values);
    for (const auto& copies : table_.shared)
      for (const auto& [s, i] : copies) {
        if (s != number_) continue;
        for (const auto& [t, j] : copies)
          if (static_cast<int>(t) == table_.portions[s].node_owner[i])
            for (std::size_t k = 0; k < count; ++k) values[i * count + k] = table_.numbers[t][j * count + k];
      }
    table_.meeting.wait();
  }
  void sum(std::span<double> values) {
    lay_out(values);
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = 0;
      for (const auto& numbers : table_.numbers) values[k] += numbers[k];
    }
    table_.meeting.wait();
  }
  double least(double value) {
    lay_out(std::span(&value, 1));
    for (const auto& numbers : table_.numbers) value = std::min(value, numbers[0]);
    table_.meeting.wait();
    return value;
  }
  bool first() const { return number_ == 0; }
  void fail(const std::string& what) { table_.meeting.fail(what); }
  void migrate(Scene& scene) {
    auto& mine = table_.arrivals[number_];
    mine.assign(table_.numbers.size(), {});
    take_foreign(scene, [&](auto body, int to, const auto& point, std::uint64_t cell) {
      mine[static_cast<std::size_t>(to)].push_back(
          [=](Scene& s) { take_in<decltype(body)::value>(s, std::vector{point}, {cell}); });
      ++migrated;
    });
    table_.meeting.wait();
    for (const auto& from : table_.arrivals)
      for (const auto& arrive : from[number_]) arrive(scene);
    table_.meeting.wait();
  }
  std::size_t migrated = 0;

 private:
  void lay_out(std::span<const double> values) {
    table_.numbers[number_].assign(values.begin(), values.end());
    table_.meeting.wait();
  }
  Table<Scene>& table_;
  std::size_t number_;
};

}  // namespace arenite::test
