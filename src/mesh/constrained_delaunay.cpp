// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "base/vec.h"
#include "rimline/run.h"

namespace rimline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<char, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

// Marks the triangles reached from outside without crossing a loop, then those across one loop, and so on:
// the surface is what an odd number of loops encloses.
void mark_depth(Cdt& cdt) {
  for (auto f : cdt.all_face_handles()) f->info() = -1;
  std::vector<Cdt::Face_handle> now{cdt.infinite_face()}, later;
  for (char depth = 0; !now.empty(); depth = static_cast<char>(1 - depth)) {
    while (!now.empty()) {
      const Cdt::Face_handle f = now.back();
      now.pop_back();
      if (f->info() != -1) continue;
      f->info() = depth;
      for (int c = 0; c < 3; ++c) {
        const Cdt::Face_handle g = f->neighbor(c);
        if (g->info() == -1) (f->is_constrained(c) ? later : now).push_back(g);
      }
    }
    std::swap(now, later);
  }
}

[[noreturn]] void throw_crossing(Index a, Index b) {
  throw Error(ErrorCode::NotADisc, "loops cross or touch in the plane", {std::min(a, b), std::max(a, b)});
}

// Inserts all points; the vertex of each point of a loop, or none for the others. Where points coincide, the
// vertex carries the one that is on a loop.
std::vector<Cdt::Vertex_handle> insert_points(Cdt& cdt, std::span<const UV> uv,
                                              const std::vector<Loop>& loops) {
  std::vector<std::pair<Kernel::Point_2, Index>> sites;
  sites.reserve(uv.size());
  for (std::size_t i = 0; i < uv.size(); ++i)
    sites.emplace_back(Kernel::Point_2(uv[i].u, uv[i].v), static_cast<Index>(i));
  cdt.insert(sites.begin(), sites.end());
  std::vector<Cdt::Vertex_handle> vertex_of(uv.size());
  for (auto v : cdt.finite_vertex_handles()) vertex_of[v->info()] = v;
  for (const Loop& loop : loops) {
    for (const Index i : loop.points) {
      if (vertex_of[i] != Cdt::Vertex_handle()) continue;
      Cdt::Locate_type type;
      int corner = 0;
      vertex_of[i] = cdt.locate(sites[i].first, type, corner)->vertex(corner);
      vertex_of[i]->info() = i;
    }
  }
  return vertex_of;
}

void insert_loop(Cdt& cdt, const std::vector<Cdt::Vertex_handle>& vertex_of, const Loop& loop) {
  for (std::size_t k = 0; k < loop.points.size(); ++k) {
    const Index a = loop.points[k], b = loop.points[next_in(k, loop.points.size())];
    if (vertex_of[a]->info() != a || vertex_of[b]->info() != b) throw_crossing(a, b);
    try {
      cdt.insert_constraint(vertex_of[a], vertex_of[b]);
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      throw_crossing(a, b);
    }
    // A point of the surface on the edge, as seen in uv, would split it.
    Cdt::Face_handle face;
    int corner = 0;
    if (!cdt.is_edge(vertex_of[a], vertex_of[b], face, corner)) throw_crossing(a, b);
  }
}

}  // namespace

std::vector<Triangle> constrained_delaunay(std::span<const UV> uv, const std::vector<Loop>& loops) {
  Cdt cdt;
  const std::vector<Cdt::Vertex_handle> vertex_of = insert_points(cdt, uv, loops);
  for (const Loop& loop : loops) insert_loop(cdt, vertex_of, loop);
  mark_depth(cdt);
  std::vector<Triangle> triangles;
  triangles.reserve(cdt.number_of_faces());
  for (auto f : cdt.finite_face_handles()) {
    if (f->info() == 1)
      triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }
  return triangles;
}

}  // namespace rimline
