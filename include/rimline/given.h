// SPDX-License-Identifier: GPL-3.0-or-later
// What may come with the points.
#pragma once

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

// What may come with the points; all may be empty.
struct Given {
  std::vector<Point> normals;  // one per point; the mesh faces the side that most of them point to
  std::vector<Loop> loops;     // a boundary made by hand, used instead of finding one
  Reference reference;         // for reconstruct
};

}  // namespace rimline
