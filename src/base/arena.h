// SPDX-License-Identifier: GPL-3.0-or-later
// Task arenas that limit parallel loops to the threads of a run.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "rimline/run.h"

namespace rimline {

// A task arena of thread_count(run) threads, borrowed for the lifetime of this object. All loops of a run
// share one arena, and one more for each level of nesting; later runs use the same arenas. An arena for each
// loop would leak memory: oneTBB 2021.8 loses about 8 kB with every arena that its workers joined.
//
// Headers of TBB stay out of this one: every second file of the library would spend a second on them.
class Arena {
 public:
  explicit Arena(const Run& run);
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena();

  // Returns what work() returns.
  template <class Work>
  auto execute(const Work& work) {
    using Result = std::invoke_result_t<const Work&>;
    if constexpr (std::is_void_v<Result>) {
      enter([](const void* own) { (*static_cast<const Work*>(own))(); }, &work);
    } else {
      std::optional<Result> result;
      const auto keep = [&] { result.emplace(work()); };
      execute(keep);
      return std::move(*result);
    }
  }

 private:
  struct Lent;
  friend struct IdleArenas;
  static Lent* lend(int threads);
  void enter(void (*call)(const void*), const void* work);

  int threads_;
  Lent* lent_;
};

}  // namespace rimline
