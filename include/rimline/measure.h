// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of a mesh, taken from its triangles alone.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/report.h"
#include "rimline/run.h"
#include "rimline/seams.h"

namespace rimline {

// `spacing` as of local_spacing(), one per point; `uv` one per point or empty, with those of `seams`. Throws
// Cancelled.
MeshSummary measure_mesh(Points points, const std::vector<Triangle>& triangles,
                         std::span<const double> spacing, std::span<const UV> uv, const Run& run = {},
                         const Seams& seams = {});

// How much the map distorts each triangle and each point.
struct Distortion {
  // Per triangle, then likewise per point, the mean over its triangles, weighted by their area in space; NaN
  // for points of no triangle.
  struct Values {
    std::vector<float> angle;    // mean difference of the corners' angles in space and in uv, radians
    std::vector<float> area;     // area in uv over area in space, both scaled to their component's whole
    std::vector<float> stretch;  // L2 of Sander et al. 2001: root mean square of the singular values of the
                                 // map from uv to space; 1 where lengths are kept; infinite for no area in uv
    std::vector<float> max_stretch;  // Linf of Sander et al. 2001: the larger singular value
  };
  Values triangle, point;
  DistortionSummary whole;
  std::vector<DistortionSummary> components;
};

// `component` has one entry per triangle, from 0 to `component_count` - 1, or is empty for one component;
// each is scaled by itself. `uv` has one entry per point; those of `seams` come on top.
Distortion measure_distortion(Points points, const std::vector<Triangle>& triangles, std::span<const UV> uv,
                              std::span<const Index> component, std::size_t component_count, const Run& run,
                              const Seams& seams = {});

// Pairs of triangles that meet in more than a shared vertex or edge, by exact predicates, as positions in
// `triangles`, ascending. Degenerate triangles are ignored. About 0.5 microseconds a triangle. At most `most`
// pairs are returned, for there may be very many; which ones does not depend on the number of threads.
std::vector<std::array<Index, 2>> find_self_intersections(
    Points points, const std::vector<Triangle>& triangles, const Run& run,
    std::size_t most = std::numeric_limits<std::size_t>::max());

// Distances from the places of DistanceSummary on each triangle to the nearest point of a mesh.
class SurfaceDistance {
 public:
  // Keeps views of both. Throws BadOption where there are no triangles.
  SurfaceDistance(Points points, const std::vector<Triangle>& triangles);
  ~SurfaceDistance();

  double to(Point place) const;
  DistanceSummary from(Points points, const std::vector<Triangle>& triangles, const Run& run) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

// F1 of two sets of edges, those of two meshes over the same vertices, as ids.
double edge_agreement(const std::vector<Triangle>& a, const std::vector<Triangle>& b);

SpacingSummary summarize_spacing(std::vector<double> spacing, const Run& run = {});

}  // namespace rimline
