// SPDX-License-Identifier: GPL-3.0-or-later
// What each stage takes: seconds and memory. The pipeline times its own; who reads and writes files around it
// times these.
#pragma once

#include <chrono>
#include <vector>

#include "rimline/report.h"

namespace rimline {

// Call enter() at the start of each stage and leave() after the last. A stage entered twice adds up.
class StageClock {
 public:
  void enter(Stage stage);
  // Enters a stage unless it is the one that runs.
  void follow(Stage stage) {
    if (!running_ || stage_ != stage) enter(stage);
  }
  void leave();
  const std::vector<StageCost>& costs() const { return costs_; }

 private:
  std::vector<StageCost> costs_;
  bool running_ = false;
  Stage stage_ = Stage::Read;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace rimline
