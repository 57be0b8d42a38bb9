// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/stage_clock.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace rimline {
namespace {

// Linux can reset the peak resident memory; on other systems a stage reports the peak so far.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

std::size_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("VmHWM:")) continue;
    std::size_t kilobytes = 0;
    std::istringstream(line.substr(6)) >> kilobytes;
    return kilobytes * 1024;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

void StageClock::enter(Stage stage) {
  if (running_) leave();
  forget_peak();
  stage_ = stage;
  start_ = std::chrono::steady_clock::now();
  running_ = true;
}

void StageClock::leave() {
  if (!running_) return;
  running_ = false;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  auto at =
      std::find_if(costs_.begin(), costs_.end(), [this](const StageCost& c) { return c.stage == stage_; });
  if (at == costs_.end()) at = costs_.insert(costs_.end(), StageCost{stage_, 0, 0});
  at->seconds += seconds;
  at->peak_bytes = std::max(at->peak_bytes, peak_bytes());
}

}  // namespace rimline
