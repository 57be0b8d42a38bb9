// SPDX-License-Identifier: GPL-3.0-or-later
// Is a mesh of an analytic surface the surface?
#pragma once

#include <vector>

#include "quality/case.h"
#include "quality/metrics.h"

namespace rimline::bench {

// sound: 1 where all of these hold, each of which is also given alone,
//   sound_topology  Euler number, boundary loops and components are the surface's
//   sound_manifold  no edge with more than two triangles, no vertex with more than one fan
//   sound_distance  farthest_from_surface and farthest_from_mesh below two spacings
//   sound_area      area within 5 %, with noise 15 %
//   sound_boundary  boundary_points_f1 at least 0.8
// farthest_from_surface: over places on the mesh, the distance to the nearest point of the dense sample;
// farthest_from_mesh: over the dense sample, the distance to the nearest place on the mesh; both in spacings
// of the nearest input point. Places lie half a spacing apart, the dense sample too, so that these are up to
// about half a spacing too large.
// `m` are the numbers of score_mesh for the same mesh; c.surface must be set.
Metrics score_soundness(const Case& c, const std::vector<Triangle>& mesh, const Metrics& m);

}  // namespace rimline::bench
