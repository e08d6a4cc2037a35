// Array memory: an allocator that places the long arrays of a scene. A step reads some twenty columns side by
// side. If all begin at the same offset in a page, as with `std::allocator`, their entries of one point map
// to one set of the first-level cache, which has fewer lines than that; this cost a seventh of the time of
// B-splines in space. Very long arrays use pages of 2 MB where the system has them: with pages of 4 KB every
// 512 numbers need another address translation (up to a sixth of the time of a million points).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Allocator for long arrays; short ones get what `std::allocator` gives.
template <class T>
struct ArrayMemory {
  using value_type = T;
  static constexpr std::size_t line = 64, page = 4096, large_page = std::size_t{1} << 21;  ///< bytes
  static constexpr std::size_t least = 16 * page;  ///< a long array, bytes
  static_assert(alignof(T) <= line);

  ArrayMemory() = default;
  template <class U>
  ArrayMemory(const ArrayMemory<U>&) {}

  T* allocate(std::size_t n) {
    if (n > PTRDIFF_MAX / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = n * sizeof(T);
    if (bytes < least) return std::allocator<T>().allocate(n);
    if (bytes >= large_page) {
      void* const memory = pages(bytes, large_page);
#ifdef __linux__
      madvise(memory, bytes, MADV_HUGEPAGE);  // only a hint; without huge pages it works too
#endif
      return static_cast<T*>(memory);
    }
    // Each begins some lines further into its first page than the one before.
    static std::atomic<std::size_t> count{0};
    constexpr std::size_t lines = page / line;
    const std::size_t offset = line * (1 + count.fetch_add(5, std::memory_order_relaxed) % (lines - 1));
    return reinterpret_cast<T*>(static_cast<char*>(pages(bytes + offset, page)) + offset);
  }

  void deallocate(T* memory, std::size_t n) {
    if (n * sizeof(T) < least) return std::allocator<T>().deallocate(memory, n);
    const std::size_t size = n * sizeof(T) >= large_page ? large_page : page;
    // The page that it begins in is the first.
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    ::operator delete (reinterpret_cast<void*>(address - address % size), std::align_val_t{size});
  }

  /// Leaves numbers without an initial value uninitialised: a page is placed in the memory of the processor
  /// that first writes to it, which is to be the one that works on it.
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }

  friend bool operator==(const ArrayMemory&, const ArrayMemory&) { return true; }

 private:
  static void* pages(std::size_t bytes, std::size_t size) {
    return ::operator new ((bytes + size - 1) / size * size, std::align_val_t{size});
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
