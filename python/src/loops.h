// SPDX-License-Identifier: GPL-3.0-or-later
// Loops as the package's objects rimline.Loop, and back.
#pragma once

#include <vector>

#include "arrays.h"
#include "rimline/mesh.h"

namespace rimline::python {

Items loops_to_python(std::vector<Loop> loops);

// Of objects with `points` and the other members of Loop. Throws BadOption where a loop is none over that
// many points: an id out of range or twice, or fewer than three.
std::vector<Loop> loops_from_python(const Items& loops, std::size_t point_count);

// Ids of points, checked against their number. Throws BadOption.
void check_ids(std::span<const Index> ids, std::size_t point_count, const char* what);

}  // namespace rimline::python
