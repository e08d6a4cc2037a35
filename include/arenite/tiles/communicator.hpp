// The communicator of a tile: its sums and messages go to the tiles of its rank through memory, to those of other ranks through `Ranks`.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <arenite/core/bytes.hpp>
#include <arenite/core/error.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/tiles/barrier.hpp>
#include <arenite/tiles/exact_sum.hpp>
#include <arenite/tiles/halo.hpp>
#include <arenite/tiles/ranks.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Bytes for tiles, or from them, by their numbers.
using Messages = std::map<int, std::string>;

/// The data that the tiles of one rank share; each tile is stepped by its own thread.
class LocalTiles {
 public:
  /// `rank_of`: [tiles of the whole] their ranks; `migrated`: bytes so far.
  LocalTiles(Ranks& ranks, Halo halo, std::vector<int> rank_of, std::size_t migrated = 0)
      : ranks_{&ranks}, halo_{std::move(halo)}, rank_of_{std::move(rank_of)}, migrated_{migrated} {
    for (int t = 0; t < size(); ++t)
      if (rank_of_[static_cast<std::size_t>(t)] == ranks.rank()) number_.push_back(t);
  }
  LocalTiles(const LocalTiles&) = delete;
  LocalTiles& operator=(const LocalTiles&) = delete;

  Ranks& ranks() const { return *ranks_; }
  std::size_t tiles() const { return halo_.tiles.size(); }
  /// Tiles of the whole, and the ranks of each.
  int size() const { return static_cast<int>(rank_of_.size()); }
  const std::vector<int>& rank_of() const { return rank_of_; }
  /// Numbers of the tiles here, ascending.
  const std::vector<int>& number() const { return number_; }
  const Halo& halo() const { return halo_; }
  /// Bytes that points have taken to other tiles since the start.
  std::size_t migrated_bytes() const { return migrated_; }

  /// Each shared node of a tile gets the sum over its copies in the order of the tiles, or the numbers of its owner.
  template <class T>
  void sum_nodes(std::size_t tile, std::span<T> values, std::size_t count) {
    const auto& buffers = pass_on(tile, values, count);
    const auto& shared = halo_.tiles[tile];
    for (std::size_t n = 0; n < shared.nodes.size(); ++n)
      for (std::size_t k = 0; k < count; ++k) {
        T total = 0;
        for (std::size_t c = shared.first[n]; c < shared.first[n + 1]; ++c)
          total += buffers[shared.copies[c].buffer][shared.copies[c].node * count + k];
        values[shared.nodes[n] * count + k] = total;
      }
  }
  template <class T>
  void share_nodes(std::size_t tile, std::span<T> values, std::size_t count) {
    const auto& buffers = pass_on(tile, values, count);
    const auto& shared = halo_.tiles[tile];
    for (std::size_t n = 0; n < shared.nodes.size(); ++n)
      std::copy_n(&buffers[shared.owned[n].buffer][shared.owned[n].node * count], count,
                  &values[shared.nodes[n] * count]);
  }

  /// Sums that do not depend on the order of the tiles.
  void sum(std::size_t tile, std::span<double> values) {
    numbers_[tile] = values;
    barrier_.wait([&] {
      std::vector<ExactSum> sums(values.size());
      for (const auto& of_tile : numbers_) {
        require(of_tile.size() == values.size(), "communicator: numbers to sum", of_tile.size(),
                "must be as many in all tiles");
        for (std::size_t k = 0; k < values.size(); ++k) sums[k].add(of_tile[k]);
      }
      if (ranks_->size() > 1 && !sums.empty()) {
        std::vector<std::int64_t> words;
        for (auto& s : sums) words.insert(words.end(), s.all().begin(), s.all().end());
        ranks_->sum(words);
        for (std::size_t k = 0; k < sums.size(); ++k)
          std::copy_n(words.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::words), ExactSum::words,
                      sums[k].all().begin());
      }
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double total = sums[k].value();
        for (const auto& of_tile : numbers_) of_tile[k] = total;
      }
    });
  }

  /// In the order of the tiles.
  std::vector<double> gather(std::size_t tile, const std::vector<double>& numbers) {
    gathered_from_[tile] = &numbers;
    barrier_.wait([&] {
      std::vector<double> here;  // of each tile its number, how many follow, and these
      for (std::size_t t = 0; t < tiles(); ++t) {
        const auto& of_tile = *gathered_from_[t];
        here.insert(here.end(), {static_cast<double>(number_[t]), static_cast<double>(of_tile.size())});
        here.insert(here.end(), of_tile.begin(), of_tile.end());
      }
      const auto all = ranks_->gather(here);
      std::vector<std::span<const double>> by_tile(rank_of_.size());
      for (std::span<const double> rest(all); !rest.empty();) {
        const auto count = static_cast<std::size_t>(rest[1]);
        by_tile[static_cast<std::size_t>(rest[0])] = rest.subspan(2, count);
        rest = rest.subspan(2 + count);
      }
      gathered_.clear();
      for (const auto& of_tile : by_tile) gathered_.insert(gathered_.end(), of_tile.begin(), of_tile.end());
    });
    return gathered_;  // the next round needs this tile, too
  }

  /// NaN counts as less than all numbers.
  double least(std::size_t tile, double value) {
    least_[tile] = std::isnan(value) ? -std::numeric_limits<double>::infinity() : value;
    barrier_.wait([&] { least_of_all_ = ranks_->least(*std::ranges::min_element(least_)); });
    return least_of_all_;  // the next round needs this tile, too
  }

  Messages exchange(std::size_t tile, Messages to) {
    to_[tile] = std::move(to);
    barrier_.wait([&] {
      for (const Messages& of_tile : to_)
        for (const auto& [other, message] : of_tile) migrated_ += message.size();
      std::vector<int> neighbours;
      for (const auto& neighbour : halo_.neighbours) neighbours.push_back(neighbour.rank);
      deliver(neighbours);
    });
    return std::exchange(from_[tile], {});
  }

  /// Bytes of all tiles, where tile 0 is.
  Messages to_first(std::size_t tile, std::string bytes) {
    to_[tile][0] = std::move(bytes);
    barrier_.wait([&] {
      std::vector<int> with{rank_of_[0]};
      if (ranks_->rank() == with.front()) {
        with.clear();
        for (int r = 0; r < ranks_->size(); ++r)
          if (r != ranks_->rank()) with.push_back(r);
      }
      deliver(with);
    });
    return std::exchange(from_[tile], {});
  }

  void fail(std::size_t tile, const std::string& what) {
    const std::string told = joined_text({"tile ", number_[tile], " failed: ", what});
    if (barrier_.fail(told)) ranks_->fail(told);
  }
  /// After a failure, once the threads of all tiles have ended: messages in transit are dropped. Other ranks may wait forever for those
  /// that this one has not sent, so that with several ranks all remain failed.
  void begin_again() {
    if (ranks_->size() > 1) return;
    barrier_.begin_again();
    std::ranges::fill(round_, 0);
    std::ranges::fill(to_, Messages());
    std::ranges::fill(from_, Messages());
  }

 private:
  /// Two sets, which take turns: a tile may write the next numbers while another still reads these.
  template <class T>
  using Buffers = std::array<std::vector<std::vector<T>>, 2>;

  /// Passes a tile's numbers at its shared nodes to all who have copies. Returns all buffers.
  template <class T>
  const std::vector<std::vector<T>>& pass_on(std::size_t tile, std::span<T> values, std::size_t count) {
    auto& buffers = std::get<Buffers<T>>(buffers_)[round_[tile]++ % 2];
    const auto& shared = halo_.tiles[tile].nodes;
    auto& own = buffers[tile];
    own.resize(shared.size() * count);
    for (std::size_t n = 0; n < shared.size(); ++n)
      std::copy_n(&values[shared[n] * count], count, &own[n * count]);
    barrier_.wait([&] { swap(buffers, count); });
    return buffers;
  }

  /// Numbers of copies to and from the neighbours.
  template <class T>
  void swap(std::vector<std::vector<T>>& buffers, std::size_t count) {
    std::vector<std::vector<T>> sent(halo_.neighbours.size());
    std::vector<Ranks::Swap> swaps;
    for (std::size_t r = 0; r < halo_.neighbours.size(); ++r) {
      const auto& neighbour = halo_.neighbours[r];
      sent[r].resize(neighbour.sent.size() * count);
      for (std::size_t n = 0; n < neighbour.sent.size(); ++n)
        std::copy_n(&buffers[neighbour.sent[n].buffer][neighbour.sent[n].node * count], count,
                    &sent[r][n * count]);
      auto& received = buffers[tiles() + r];
      received.resize(neighbour.received * count);
      swaps.push_back(
          {neighbour.rank, std::as_bytes(std::span(sent[r])), std::as_writable_bytes(std::span(received))});
    }
    ranks_->swap(swaps);
  }

  /// Messages of the tiles here to tiles here and of these ranks, which call it with this one among theirs: of which, to which, length,
  /// bytes.
  void deliver(const std::vector<int>& ranks) {
    std::vector<std::string> out(ranks.size());
    for (std::size_t t = 0; t < tiles(); ++t) {
      for (auto& [to, message] : to_[t]) {
        const int own = number_[t], rank = rank_of_.at(static_cast<std::size_t>(to));
        if (rank == ranks_->rank()) {
          from_[here(to)][own] = std::move(message);
          continue;
        }
        const auto at = std::ranges::find(ranks, rank);
        if (at == ranks.end())
          throw run_error(
              joined_text({"tile ", own, " has points for tile ", to, ", with which it shares no node"}));
        auto& bytes = out[static_cast<std::size_t>(at - ranks.begin())];
        append_bytes(bytes, own);
        append_bytes(bytes, to);
        append_bytes(bytes, message.size());
        bytes += message;
      }
      to_[t].clear();
    }
    for (const auto& bytes : ranks_->exchange(ranks, out))
      for (std::string_view rest = bytes; !rest.empty();) {
        const int of = read_bytes<int>(rest), to = read_bytes<int>(rest);
        const auto size = read_bytes<std::size_t>(rest);
        from_[here(to)][of] = rest.substr(0, size);
        rest.remove_prefix(size);
      }
  }

  /// Place of a tile among those here.
  std::size_t here(int tile) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(number_, tile) - number_.begin());
  }

  Ranks* ranks_;
  Halo halo_;
  std::vector<int> rank_of_;
  std::vector<int> number_{};
  Barrier barrier_{tiles()};
  std::vector<std::size_t> round_ = std::vector<std::size_t>(tiles());  // [tiles] exchanges of nodes so far
  std::tuple<Buffers<double>, Buffers<float>, Buffers<long double>> buffers_ = made_buffers();
  std::vector<std::span<double>> numbers_ = std::vector<std::span<double>>(tiles());
  std::vector<double> least_ = std::vector<double>(tiles());
  double least_of_all_ = 0;
  std::vector<const std::vector<double>*> gathered_from_ = std::vector<const std::vector<double>*>(tiles());
  std::vector<double> gathered_{};
  std::vector<Messages> to_ = std::vector<Messages>(tiles()), from_ = to_;  // [tiles] by the other tile
  std::size_t migrated_;

  std::tuple<Buffers<double>, Buffers<float>, Buffers<long double>> made_buffers() const {
    const auto made = [&](auto all) {
      for (auto& set : all) set.resize(tiles() + halo_.neighbours.size());
      return all;
    };
    return {made(Buffers<double>{}), made(Buffers<float>{}), made(Buffers<long double>{})};
  }
};

/// The place of a tile: all copies of its communicator refer to it, so that it may change.
struct TileSlot {
  LocalTiles* all = nullptr;
  std::size_t tile = 0;  ///< among those of the rank
};

/// The communicator of the scene over a tile (see `parallel/communicator.hpp`): a handle.
class TileCommunicator {
 public:
  static constexpr bool is_serial = false;
  using Messages = arenite::Messages;
  explicit TileCommunicator(const TileSlot& slot) : slot_{&slot} {}

  template <class T>
  void sum_nodes(std::span<T> values, std::size_t count) const {
    all().sum_nodes(slot_->tile, values, count);
  }
  template <class T>
  void share_nodes(std::span<T> values, std::size_t count) const {
    all().share_nodes(slot_->tile, values, count);
  }
  void sum(std::span<double> values) const { all().sum(slot_->tile, values); }
  std::vector<double> gather(const std::vector<double>& numbers) const {
    return all().gather(slot_->tile, numbers);
  }
  double least(double value) const { return all().least(slot_->tile, value); }
  /// Whether it is tile 0, which writes what is of the whole.
  bool first() const { return all().number()[slot_->tile] == 0; }
  int size() const { return all().size(); }
  Messages exchange(Messages to) const { return all().exchange(slot_->tile, std::move(to)); }
  Messages to_first(std::string bytes) const { return all().to_first(slot_->tile, std::move(bytes)); }
  void fail(const std::string& what) const { all().fail(slot_->tile, what); }

 private:
  LocalTiles& all() const { return *slot_->all; }

  const TileSlot* slot_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
