// SPDX-License-Identifier: GPL-3.0-or-later
// Where the picture looks from: an orthographic camera chosen from the points and their boundary.
#pragma once

#include <optional>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::cli {

// Three unit vectors at right angles. `toward` points from the scene to the eye.
struct View {
  Point right, up, toward;

  // x to the right, y up, z toward the eye.
  Point project(Point p) const { return {dot(p, right), dot(p, up), dot(p, toward)}; }
};

// A three-quarter view. What opens to one side (a head open at the neck, a cap) stands with its opening
// below; a sheet is looked at from its flat side, `front` telling which. With `up` given, that way is up.
View choose_view(Points points, const std::vector<Loop>& loops, Point front, std::optional<Point> up);

}  // namespace rimline::cli
