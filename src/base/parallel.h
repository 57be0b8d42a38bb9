// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops whose result does not depend on the number of threads: item i writes slot i, nothing else.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "base/arena.h"
#include "rimline/run.h"

namespace rimline {

// Calls call(body, begin, end) for slices of [first, last) of about `grain` items, in the arena of the
// caller.
void run_slices(std::size_t first, std::size_t last, std::size_t grain,
                void (*call)(const void* body, std::size_t begin, std::size_t end), const void* body);

// The same for any function body(begin, end).
template <class Body>
void run_slices(std::size_t first, std::size_t last, std::size_t grain, const Body& body) {
  run_slices(
      first, last, grain,
      [](const void* own, std::size_t begin, std::size_t end) {
        (*static_cast<const Body*>(own))(begin, end);
      },
      &body);
}

// Calls body(k) for every k in [0, count), in the arena of the caller.
template <class Body>
void run_tasks(std::size_t count, const Body& body) {
  run_slices(0, count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) body(k);
  });
}

// Calls body(begin, end) over slices of [0, count). Progress is reported by the thread that called, between
// batches of slices; a cancelled run throws Error{Cancelled} there. `grain` is the number of items in one
// task, which should be long enough to hide its cost.
template <class Body>
void parallel_slices(std::size_t count, Stage stage, const Run& run, const Body& body,
                     std::size_t grain = 1024) {
  const std::size_t batch = 256 * grain;  // items between two looks at progress and cancel
  Arena arena(run);
  for (std::size_t first = 0; first < count; first += batch) {
    run.progress(stage, first, count);
    const std::size_t last = std::min(count, first + batch);
    arena.execute([&] {
      run_slices(first, last, grain, [&](std::size_t begin, std::size_t end) {
        if (!run.cancelled()) body(begin, end);
      });
    });
  }
  run.progress(stage, count, count);
}

// Calls body(k) for every k in [0, count): few tasks, each long enough for a thread of its own.
template <class Body>
void parallel_tasks(std::size_t count, Stage stage, const Run& run, const Body& body) {
  run.progress(stage, 0, count);
  Arena arena(run);
  arena.execute([&] {
    run_tasks(count, [&](std::size_t k) {
      if (!run.cancelled()) body(k);
    });
  });
  run.progress(stage, count, count);
}

// Calls body(i) for every i in [0, count).
template <class Body>
void parallel_for_each(std::size_t count, Stage stage, const Run& run, const Body& body) {
  parallel_slices(count, stage, run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(static_cast<Index>(i));
  });
}

// What the calls of body(i, found) append to `found`, for i from 0 to count - 1, in this order. `grain` is
// the number of items in one task.
template <class Item, class Body>
std::vector<Item> parallel_gather(std::size_t count, Stage stage, const Run& run, const Body& body,
                                  std::size_t grain = 4096) {
  std::vector<std::vector<Item>> found((count + grain - 1) / grain);
  parallel_slices(
      found.size(), stage, run,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t s = first; s < last; ++s) {
          const std::size_t end = std::min(count, (s + 1) * grain);
          for (std::size_t i = s * grain; i < end; ++i) body(static_cast<Index>(i), found[s]);
        }
      },
      1);
  std::size_t total = 0;
  for (const auto& items : found) total += items.size();
  std::vector<Item> all;
  all.reserve(total);
  for (const auto& items : found) all.insert(all.end(), items.begin(), items.end());
  return all;
}

}  // namespace rimline
