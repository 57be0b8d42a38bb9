// SPDX-License-Identifier: GPL-3.0-or-later
// A soft threshold.
#pragma once

#include <algorithm>

namespace rimline {

// 0 up to the first value, 1 from the last on, linear in between.
inline double ramp(double value, double first, double last) {
  return std::clamp((value - first) / (last - first), 0.0, 1.0);
}

}  // namespace rimline
