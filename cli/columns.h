// SPDX-License-Identifier: GPL-3.0-or-later
// Results as properties of the points in POINTS.ply and MESH.ply, beside the input's own. A property of the
// input with one of these names is replaced: a `boundary` in the input is ground truth from elsewhere.
#pragma once

#include <vector>

#include "rimline/cloud.h"
#include "rimline/pipeline.h"

namespace rimline::cli {

// boundary (uchar), loop (int), candidate (uchar), p_value (double), score (double).
void put_boundary_columns(Cloud& cloud, const BoundaryResult& result);
// Adds the vertices of fills to the points, with no value (NaN, or 0 for integers) in the input's properties,
// and as unflagged points to what is known of each point.
void add_fill_vertices(Cloud& cloud, const std::vector<Point>& added, BoundaryResult& boundary);
// angle_distortion, area_distortion, stretch_l2, stretch_linf (float).
std::vector<Column> distortion_columns(const Distortion::Values& values);
// u, v (double), boundary (uchar).
void put_map_columns(Cloud& cloud, const std::vector<UV>& uv, const std::vector<std::uint8_t>& boundary);

}  // namespace rimline::cli
