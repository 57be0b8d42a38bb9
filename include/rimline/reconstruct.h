// SPDX-License-Identifier: GPL-3.0-or-later
// From points to a mesh that ends at the boundary of their surface.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "rimline/find_boundary.h"
#include "rimline/measure.h"
#include "rimline/seams.h"

namespace rimline {

// Loops of filled holes are not loops of the result, and their points are not on the boundary.
struct ReconstructResult {
  BoundaryResult boundary;
  std::vector<Point> added;  // new vertices of filled holes; their ids follow those of the input
  std::vector<UV> uv;  // per point and added vertex, charts side by side; NaN where a point has no position,
                       // or several: then they are in `seams`
  std::vector<Triangle> triangles;
  Seams seams;               // corner_uv() gives the position of each corner of each triangle
  std::vector<Index> chart;  // per triangle, from 0, or `none` without a map; empty in the paper's presets
  std::vector<Index> patch;  // likewise, or `none`; empty in the paper's presets
  std::vector<std::uint8_t> filled;  // per triangle, 1 where it closes a hole; empty in the paper's presets
  Distortion distortion;             // per triangle, and per point and added vertex
};

// Thrown where no triangle can be given, or not all under MeshOptions::strict. Holds what was found.
class NoMesh : public Error {
 public:
  NoMesh(const Error& reason, BoundaryResult result) : Error(reason), found(std::move(result)) {}
  BoundaryResult found;
};

// The whole method. Throws what find_boundary throws; once points are scored also NoMesh, with the code of
// the reason. Points in no triangle are listed in the report, and are an error under MeshOptions::strict
// only.
ReconstructResult reconstruct(Points points, const Options& options, const Run& run, const Given& given = {});

}  // namespace rimline
