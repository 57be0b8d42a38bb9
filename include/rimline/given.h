// SPDX-License-Identifier: GPL-3.0-or-later
// What may come with the points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline {

// A mesh to measure the result against.
struct Reference {
  std::string name;  // for the report
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

// The place of a point in its scanner's raster, from 0. Columns follow each other as the scanner turns, rows
// within a column.
struct RasterCell {
  Index column = 0, row = 0;
};

// What may come with the points; all may be empty.
struct Given {
  std::vector<Point> normals;  // one per point; the mesh faces the side that most of them point to
  std::vector<Loop> loops;     // a boundary made by hand, used instead of finding one
  Reference reference;         // for reconstruct
  // One per point, all of one scan; the preset `default` takes the triangles between neighbouring cells, where
  // these fit the points (Cloud::raster).
  std::vector<RasterCell> raster = {};
  std::optional<Point> viewpoint = {};  // of the scanner: depths along its rays may be in steps
};

}  // namespace rimline
