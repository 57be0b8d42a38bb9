// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/arena.h"

#include <doctest/doctest.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "base/parallel.h"

namespace rimline {
namespace {

Run on_threads(int threads) {
  Run run;
  run.threads = threads;
  return run;
}

long resident_bytes() {
  std::ifstream file("/proc/self/statm");
  long all = 0, resident = 0;
  file >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

// A loop that a worker joins, unless it takes too long to come.
void joined_loop(const Run& run) {
  std::atomic<int> here{0};
  const auto late = std::chrono::steady_clock::now() + std::chrono::milliseconds(2);
  parallel_tasks(2, Stage::Survey, run, [&](std::size_t) {
    ++here;
    while (here < 2 && std::chrono::steady_clock::now() < late) std::this_thread::yield();
  });
}

}  // namespace

TEST_CASE("loops that follow each other take the same arena, and lose no memory") {
  const Run run = on_threads(2);
  for (int i = 0; i < 200; ++i) joined_loop(run);
  const long before = resident_bytes();
  for (int i = 0; i < 1000; ++i) joined_loop(run);  // 8 MB, if each took an arena of its own
  CHECK(resident_bytes() - before < 2'000'000);
}

TEST_CASE("a loop keeps to the threads of its run, and loops within loops give the same") {
  for (const int threads : {1, 2, 3}) {
    const Run run = on_threads(threads);
    Arena arena(run);
    CHECK(arena.execute([] { return tbb::this_task_arena::max_concurrency(); }) <= threads);
    std::vector<std::vector<Index>> made(8, std::vector<Index>(3000));
    parallel_tasks(made.size(), Stage::Survey, run.without_progress(), [&](std::size_t k) {
      parallel_for_each(made[k].size(), Stage::Survey, run.without_progress(),
                        [&](Index i) { made[k][static_cast<std::size_t>(i)] = i * static_cast<Index>(k); });
    });
    for (std::size_t k = 0; k < made.size(); ++k) {
      for (std::size_t i = 0; i < made[k].size(); ++i)
        REQUIRE(made[k][i] == static_cast<Index>(i) * static_cast<Index>(k));
    }
  }
}

TEST_CASE("an arena comes back from a loop that threw") {
  const Run run = on_threads(2);
  for (int i = 0; i < 50; ++i) {
    CHECK_THROWS_AS(parallel_tasks(4, Stage::Survey, run,
                                   [](std::size_t k) {
                                     if (k == 2) throw std::runtime_error("from a task");
                                   }),
                    std::runtime_error);
  }
  int calls = 0;
  parallel_tasks(1, Stage::Survey, run, [&](std::size_t) { ++calls; });
  CHECK(calls == 1);
}

}  // namespace rimline
