// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/arena.h"

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "base/threads.h"

namespace rimline {
namespace {

// The idle arenas, by their number of threads.
struct Idle {
  std::mutex mutex;
  std::map<int, std::vector<std::unique_ptr<tbb::task_arena>>> of_threads;
};

// Never destroyed, because oneTBB may be shut down first.
Idle& idle() {
  static Idle& all = *new Idle;
  return all;
}

tbb::task_arena* lend(int threads) {
  const std::lock_guard lock(idle().mutex);
  auto& waiting = idle().of_threads[threads];
  if (waiting.empty()) return new tbb::task_arena(threads);
  tbb::task_arena* const last = waiting.back().release();
  waiting.pop_back();
  return last;
}

}  // namespace

Arena::Arena(const Run& run) : threads_(thread_count(run)), lent_(lend(threads_)) {}

Arena::~Arena() {
  std::unique_ptr<tbb::task_arena> back(lent_);
  const std::lock_guard lock(idle().mutex);
  idle().of_threads[threads_].push_back(std::move(back));
}

}  // namespace rimline
