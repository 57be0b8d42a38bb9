// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of a run (seed, threads, progress, cancellation), and errors.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// The stages in the order of the data flow.
enum class Stage {
  Read,
  Arrange,
  Neighbours,
  Boundary,
  Survey,
  Loops,
  Parameterize,
  Triangulate,
  Refine,
  Measure,
  Write  // in the library: the result is put into the order of the input
};

// The stage's name as users read it: "neighbours", "loops", ...
const char* name(Stage stage);

// Progress of a stage: `done` of `total` steps. `total` may be 0 where it is not known.
struct Progress {
  Stage stage = Stage::Read;
  std::size_t done = 0;
  std::size_t total = 0;
};

// Settings that are not part of the method. Only the seed changes the result.
struct Run {
  std::uint64_t seed = 1;  // every random stream starts from it
  int threads = 0;         // most threads used at once; 0 takes all cores. The result does not depend on it.

  // Memory limit of the process in bytes, 0 for none. Where the estimate of memory.h, or the size of a file,
  // exceeds it, OutOfMemory is thrown before anything of that size is allocated.
  std::size_t memory_limit = 0;

  // Called from the thread that called the stage, at least ten times a second on long work.
  std::function<void(Progress)> on_progress = {};

  // Set it (from another thread or a signal handler) and the running stage throws Error{Cancelled} soon
  // after, well within a second.
  const std::atomic<bool>* stop = nullptr;

  // For the stages: reports progress, and throws Cancelled where the caller wants to stop.
  void progress(Stage stage, std::size_t done, std::size_t total) const {
    check_cancel();
    if (on_progress) on_progress({stage, done, total});
  }
  void check_cancel() const;
  // The same run for a part of a stage, which reports no progress.
  Run without_progress() const {
    Run silent = *this;
    silent.on_progress = {};
    return silent;
  }
  bool cancelled() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

// Reasons why a stage fails, grouped by the exit status of the tool.
enum class ErrorCode {
  BadOption,            // 1: an option is out of its range, or two do not go together
  CannotRead,           // 2: the input is missing, truncated or not what its format says
  TooFewPoints,         // 3: fewer points than the stage needs
  NoClosedLoop,         // 3: no closed loop was found, or the surface is closed
  UnreachableInterior,  // 3: interior points without a chain of neighbours to the loop: eq. (4) is singular
  NotADisc,             // 3: a patch is closed, has a handle, or is one-sided, where the stage needs a disc
  NoConvergence,        // 3: the linear solve did not reach its residual
  OutOfMemory,          // 4: the memory, or the limit set on it, does not suffice
  CannotWrite,          // 4: the output can not be written
  Cancelled,            // 5: Run::stop was set
};

// The exit status of the tool for a code: 1 to 5, as listed above.
int exit_status(ErrorCode code);

// Thrown by every stage that can not give all of its result. The library never prints and never exits.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message, std::vector<Index> ids = {})
      : std::runtime_error(message), code_(code), ids_(std::move(ids)) {}

  ErrorCode code() const { return code_; }
  // Ids of the points that are the reason, ascending, in the ids of the stage that threw; may be empty.
  const std::vector<Index>& ids() const { return ids_; }

 private:
  ErrorCode code_;
  std::vector<Index> ids_;
};

}  // namespace rimline
