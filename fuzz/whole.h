// SPDX-License-Identifier: GPL-3.0-or-later
// What a fuzz target checks of a cloud that was read.
#pragma once

#include <cstdlib>

#include "rimline/cloud.h"

namespace rimline::fuzz {

// Every column has a value for every point.
inline void check_whole(const Cloud& cloud) {
  for (const Column& column : cloud.columns) {
    if (column.bytes.size() != cloud.points.size() * size_in_bytes(column.type)) std::abort();
  }
}

}  // namespace rimline::fuzz
