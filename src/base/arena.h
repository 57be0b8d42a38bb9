// SPDX-License-Identifier: GPL-3.0-or-later
// Task arenas that limit parallel loops to the threads of a run.
#pragma once

#include <oneapi/tbb/task_arena.h>

#include "rimline/run.h"

namespace rimline {

// A task arena of thread_count(run) threads, borrowed for the lifetime of this object. All loops of a run
// share one arena, and one more for each level of nesting; later runs use the same arenas. An arena for each
// loop would leak memory: oneTBB 2021.8 loses about 8 kB with every arena that its workers joined.
class Arena {
 public:
  explicit Arena(const Run& run);
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena();

  template <class Work>
  auto execute(const Work& work) {
    return lent_->execute(work);
  }

 private:
  int threads_;
  tbb::task_arena* lent_;
};

}  // namespace rimline
