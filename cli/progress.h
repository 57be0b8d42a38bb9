// SPDX-License-Identifier: GPL-3.0-or-later
// The progress bar: one line on standard error, only where that is a terminal.
#pragma once

#include <chrono>

#include "rimline/run.h"

namespace rimline::cli {

class ProgressBar {
 public:
  // Shows nothing where standard error is no terminal.
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { erase(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Redraws the line, at most twenty times a second within one stage.
  void show(Progress progress);
  // Removes the line.
  void erase();

 private:
  bool active_;
  bool drawn_ = false;
  Stage stage_ = Stage::Read;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace rimline::cli
