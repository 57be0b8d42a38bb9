// SPDX-License-Identifier: GPL-3.0-or-later
// One run of a subcommand: seed, threads, progress and Ctrl-C for the library, and the clock.
#pragma once

#include <chrono>

#include "arguments.h"
#include "interrupt.h"
#include "progress.h"
#include "rimline/stage_clock.h"

namespace rimline::cli {

class Session {
 public:
  explicit Session(const Common& common) : bar_(!common.quiet) {
    run_.seed = common.seed;
    run_.threads = common.threads;
    run_.memory_limit = common.memory_limit;
    run_.stop = &interrupted;
    run_.on_progress = [this](Progress progress) { bar_.show(progress); };
  }

  const Run& run() const { return run_; }
  ProgressBar& bar() { return bar_; }
  // Of reading and writing; the library times what lies between.
  StageClock& clock() { return clock_; }
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  ProgressBar bar_;
  StageClock clock_;
  Run run_;
};

}  // namespace rimline::cli
