// SPDX-License-Identifier: GPL-3.0-or-later
// Memory for large results that is cheap to touch for the first time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rimline {

// Resizes an empty vector. Linux is asked for large pages first: with small ones a result of half a gigabyte
// costs more than a hundred thousand page faults. Where the system says no, nothing changes.
template <class T>
void resize_in_large_pages(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
#ifdef __linux__
  constexpr std::uintptr_t page = 2 << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(values.data());
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t last = (begin + count * sizeof(T)) / page * page;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
  values.resize(count);
}

}  // namespace rimline
