// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace rimline::cli {
namespace {

constexpr std::size_t width = 30;
constexpr auto period = std::chrono::milliseconds(50);

std::string line(Progress progress) {
  if (progress.total == 0) return fmt::format("\r\033[K{:<13}", name(progress.stage));
  const double share =
      static_cast<double>(std::min(progress.done, progress.total)) / static_cast<double>(progress.total);
  const auto filled = static_cast<std::size_t>(share * width);
  return fmt::format("\r\033[K{:<13} [{}{}] {:3.0f} %", name(progress.stage), std::string(filled, '#'),
                     std::string(width - filled, '.'), 100 * share);
}

}  // namespace

ProgressBar::ProgressBar(bool wanted) : active_(wanted && isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(Progress progress) {
  if (!active_) return;
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && progress.stage == stage_ && now - last_ < period) return;
  stage_ = progress.stage;
  last_ = now;
  drawn_ = true;
  const std::string text = line(progress);
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void ProgressBar::erase() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace rimline::cli
