// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <cstring>

namespace rimline::python {

std::vector<Triangle> as_triangles(const TriangleRows& rows) {
  std::vector<Triangle> triangles(rows.shape(0));
  if (!triangles.empty()) std::memcpy(triangles.data(), rows.data(), triangles.size() * sizeof(Triangle));
  return triangles;
}

}  // namespace rimline::python
