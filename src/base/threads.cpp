// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/threads.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <latch>
#include <memory>
#include <thread>
#include <vector>

namespace rimline {
namespace {

void* wait_at(void* latch) {
  static_cast<std::latch*>(latch)->wait();
  return nullptr;
}

// The number of `wanted` threads that the system creates, all at the same time, with stacks as large as
// TBB's.
int makeable_threads(int wanted) {
  constexpr std::size_t stack = std::size_t{4} << 20;
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return 0;
  pthread_attr_setstacksize(&attributes, stack);
  std::latch all_made(1);
  std::vector<pthread_t> threads;
  threads.reserve(static_cast<std::size_t>(wanted));
  for (pthread_t made; static_cast<int>(threads.size()) < wanted; threads.push_back(made)) {
    if (pthread_create(&made, &attributes, wait_at, &all_made) != 0) break;
  }
  all_made.count_down();
  for (const pthread_t thread : threads) pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  return static_cast<int>(threads.size());
}

// Makes TBB start its workers, which then stay: each takes a task that ends when all have arrived, or after a
// while.
void start_workers(int threads) {
  constexpr auto patience = std::chrono::milliseconds(100);
  std::atomic<int> here{0};
  const auto begin = std::chrono::steady_clock::now();
  tbb::task_arena(threads).execute([&] {
    tbb::parallel_for(
        0, threads,
        [&](int) {
          ++here;
          while (here < threads && std::chrono::steady_clock::now() - begin < patience)
            std::this_thread::yield();
        },
        tbb::simple_partitioner());
  });
}

// The threads available to this process, determined once.
struct Usable {
  int count = tbb::info::default_concurrency();
  std::unique_ptr<tbb::global_control> most;  // limits TBB to `count` where the system creates no more

  Usable() {
    const int machine = std::max(1, count);
    count = 1 + makeable_threads(machine - 1);
    if (count < machine) {
      most = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                   static_cast<std::size_t>(count));
    }
    if (count > 1) start_workers(count);
  }
};

}  // namespace

int thread_count(const Run& run) {
  if (run.threads == 1) return 1;
  static const Usable usable;
  // More threads than the machine has would not be created, and TBB would warn on standard error.
  return run.threads <= 0 ? usable.count : std::min(run.threads, usable.count);
}

}  // namespace rimline
