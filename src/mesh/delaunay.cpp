// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

namespace rimline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

}  // namespace

std::vector<Triangle> delaunay(std::span<const UV> uv, const Run& run) {
  run.progress(Stage::Triangulate, 0, 2);
  std::vector<std::pair<Kernel::Point_2, Index>> sites;
  sites.reserve(uv.size());
  for (Index i = 0; i < static_cast<Index>(uv.size()); ++i)
    sites.emplace_back(Kernel::Point_2(uv[i].u, uv[i].v), i);
  const Delaunay triangulation(sites.begin(), sites.end());
  run.progress(Stage::Triangulate, 1, 2);

  std::vector<Triangle> triangles;
  triangles.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles()) {
    Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace rimline
