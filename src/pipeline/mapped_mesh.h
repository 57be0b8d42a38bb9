// SPDX-License-Identifier: GPL-3.0-or-later
// The surface in the plane and in space.
#pragma once

#include <string>
#include <vector>

#include "rimline/boundary_loops.h"
#include "rimline/mesh.h"
#include "rimline/report.h"
#include "rimline/seams.h"

namespace rimline::pipeline {

// Ids are those of the arrangement, then those of the vertices that fills added.
struct MappedMesh {
  std::vector<Point> vertices;  // the points of the arrangement, then those that fills added
  std::vector<UV> uv;           // one per vertex; NaN where there is none, or several, which are in `seams`
  Seams seams;
  std::vector<Index> patch;  // of each vertex, or `none`; empty where there is one patch only
  std::vector<Triangle> triangles;
  std::vector<Index> triangle_patch;  // as `patch`
  std::vector<Index> chart;  // per triangle, or `none` without a map; empty where charts are not numbered
  std::vector<char> filled;  // per triangle, 1 where it closes a hole, or empty
  std::vector<Loop> loops;   // the boundary of the mesh, the surface on the left
  std::vector<PointLabel> label;  // FoundLoops::label, except at filled holes
  MapSummary map;
  std::vector<ComponentSummary> components;  // one per patch, or empty
  std::optional<HoleSummary> holes;
  std::vector<LeftOut> left_out;  // in ids of the input
  std::string unmeshed;           // why used points may be in no triangle: the end of a sentence
  std::vector<std::string> warnings;
};

}  // namespace rimline::pipeline
