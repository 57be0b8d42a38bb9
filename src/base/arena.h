// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parallel loops of a run take place, so that they keep to its number of threads.
#pragma once

#include <oneapi/tbb/task_arena.h>

#include "rimline/run.h"

namespace rimline {

// A task arena of thread_count(run) threads, lent while this object lives. A run has one, which all its loops
// take in turn, and one more for each depth of loops within loops; runs that come later take the same. An
// arena for each loop would cost memory that is not given back: oneTBB 2021.8 loses about 8 kB with every
// arena that its workers joined.
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
