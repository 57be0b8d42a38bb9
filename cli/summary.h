// SPDX-License-Identifier: GPL-3.0-or-later
// A summary of a run in a few lines.
#pragma once

#include <string>

#include "rimline/report.h"

namespace rimline::cli {

// `files`: what was written, or "".
std::string summary(const Report& report, const std::string& files, double seconds);

// 12745 -> "12,745".
std::string with_commas(long long number);

}  // namespace rimline::cli
