// SPDX-License-Identifier: GPL-3.0-or-later
// From the plane to the mesh: section 5 of the paper.
#pragma once

#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The Delaunay triangulation of the parameter points, with exact predicates: no point lies inside the
// circumcircle of a triangle, and triangles are counter-clockwise in uv. All uv must be finite. Triangles are
// in ascending order of their ids (each rotated to start with its least id), whatever order they were found
// in. Of points at one and the same place the first is used and the others are in no triangle.
std::vector<Triangle> delaunay(std::span<const UV> uv, const Run& run);

// Flips all triangles where they face away from the input's normals (`normals`, one per point, on average
// over the triangles), or from `up` where there are none. Returns whether they were flipped.
bool orient_mesh(Points points, std::vector<Triangle>& triangles, std::span<const Point> normals, Point up);

}  // namespace rimline
