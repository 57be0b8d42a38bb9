// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the seconds and the memory of each stage. The pipeline measures its own stages; who reads and
// writes files around it measures these.
#pragma once

#include <chrono>
#include <vector>

#include "rimline/report.h"

namespace rimline {

// Call enter() at the start of each stage and leave() after the last one. The costs of a stage that is
// entered twice are added.
class StageClock {
 public:
  void enter(Stage stage);
  // Enters a stage unless it is already running.
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
