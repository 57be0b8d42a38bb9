// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/arena.h"

#include <oneapi/tbb/task_arena.h>

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "base/threads.h"

namespace rimline {

struct Arena::Lent {
  explicit Lent(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

// The idle arenas, by their number of threads.
struct IdleArenas {
  std::mutex mutex;
  std::map<int, std::vector<std::unique_ptr<Arena::Lent>>> of_threads;

  // Never destroyed, because oneTBB may be shut down first.
  static IdleArenas& all() {
    static IdleArenas& arenas = *new IdleArenas;
    return arenas;
  }
};

Arena::Lent* Arena::lend(int threads) {
  IdleArenas& idle = IdleArenas::all();
  const std::lock_guard lock(idle.mutex);
  auto& waiting = idle.of_threads[threads];
  if (waiting.empty()) return new Lent(threads);
  Lent* const last = waiting.back().release();
  waiting.pop_back();
  return last;
}

Arena::Arena(const Run& run) : threads_(thread_count(run)), lent_(lend(threads_)) {}

Arena::~Arena() {
  std::unique_ptr<Lent> back(lent_);
  IdleArenas& idle = IdleArenas::all();
  const std::lock_guard lock(idle.mutex);
  idle.of_threads[threads_].push_back(std::move(back));
}

void Arena::enter(void (*call)(const void*), const void* work) {
  lent_->arena.execute([&] { call(work); });
}

}  // namespace rimline
