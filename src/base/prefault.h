// SPDX-License-Identifier: GPL-3.0-or-later
// Large arrays whose pages are touched by all threads in parallel. Otherwise one thread would touch and zero
// all pages, which can take longer than computing the values.
#pragma once

#include <cstddef>
#include <vector>

#include "base/parallel.h"

namespace rimline {

// The same as items.resize(count) for an empty vector, with capacity for `more` items after these.
template <class T>
void resize_together(std::vector<T>& items, std::size_t count, const Run& run, std::size_t more = 0) {
  constexpr std::size_t page = 4096, block_size = std::size_t{1} << 21;
  items.reserve(count + more);
  char* const first = reinterpret_cast<char*>(items.data());
  const std::size_t bytes = count * sizeof(T);
  if (bytes >= 4 * block_size) {
    Arena(run).execute([&] {
      run_tasks(bytes / block_size, [&](std::size_t block) {
        char* const from = first + block * block_size;
        for (std::size_t i = 0; i < block_size; i += page) *static_cast<volatile char*>(from + i) = 0;
      });
    });
  }
  run.check_cancel();
  items.resize(count);
}

}  // namespace rimline
