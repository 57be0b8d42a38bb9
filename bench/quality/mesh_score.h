// SPDX-License-Identifier: GPL-3.0-or-later
// How good a mesh is. Numbers of the same name agree with score.py.
#pragma once

#include <span>
#include <vector>

#include "quality/case.h"
#include "quality/loop_score.h"
#include "quality/metrics.h"

namespace rimline::bench {

// From the triangles alone:
//   faces, points_used (share), degenerate_faces, nonmanifold_edges, nonmanifold_vertices,
//   orientation_conflicts, components, euler, boundary_loops, boundary_degree_two, self_intersections
//   (pairs), min_angle_below_10deg (share of triangles), edges_longer_than_3_spacings (share of inner edges;
//   the larger spacing of the two ends)
// Against a truth mesh: edges_agree, edges_agree_flipped, boundary_edges_precision/_recall/_f1,
//   area_over_truth, loops_true, edges_longer_than_3_spacings_in_truth, min_angle_below_10deg_in_truth,
//   topology_right (Euler number, components and loops are the truth's, and it is manifold),
//   self_intersections_in_truth
// Against the flags: boundary_points_f1.
// With uv (one per point): uv_flipped_triangles, uv_mean_angle_error_rad.
Metrics score_mesh(const Case& c, const std::vector<Triangle>& mesh, std::span<const UV> uv);

// Whether the edges with one triangle are the edges of the loops, each once, and no other: 0 or 1 as
// boundary_is_loops.
Metrics score_rim(const std::vector<Triangle>& mesh, const LoopIds& loops);

double area_of(Points points, const std::vector<Triangle>& mesh);

}  // namespace rimline::bench
