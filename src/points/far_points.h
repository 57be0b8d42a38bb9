// SPDX-License-Identifier: GPL-3.0-or-later
// Points out of all proportion: a wrong number in the file, next to which all others would be one place.
#pragma once

#include <optional>

#include "points/morton.h"
#include "rimline/run.h"

namespace rimline {

// The box outside of which points are out of proportion: more than 2^20 times as far from the quarters of the
// coordinates as these are apart. `all` is the box of the finite points. None where there is no such point,
// or more than one of a hundred (then they are data), or no quarters to compare with. Independent of the
// order.
std::optional<PointBox> box_without_far_points(Points points, const PointBox& all, const Run& run);

}  // namespace rimline
