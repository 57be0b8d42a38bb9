// SPDX-License-Identifier: GPL-3.0-or-later
// Results as properties of the points: what POINTS.ply and MESH.ply hold beside the input's own.
#pragma once

#include <vector>

#include "rimline/cloud.h"
#include "rimline/pipeline.h"

namespace rimline::cli {

// Puts a column behind the others, in the place of one with its name (a `boundary` in the input is truth
// from elsewhere, not ours).
void put_column(Cloud& cloud, Column column);

// boundary (uchar), loop (int), candidate (uchar), p_value (double), score (double).
void put_boundary_columns(Cloud& cloud, const BoundaryResult& result);
// u, v (double), boundary (uchar).
void put_map_columns(Cloud& cloud, const std::vector<UV>& uv, const std::vector<std::uint8_t>& boundary);

}  // namespace rimline::cli
