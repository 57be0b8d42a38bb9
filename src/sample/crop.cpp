// SPDX-License-Identifier: GPL-3.0-or-later
// A crop with a boundary that is known: see draft.h.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <utility>

#include "base/vec.h"
#include "sample/draft.h"

namespace rimline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices>>;
using Face = Triangulation::Face_handle;
using Vertex = Triangulation::Vertex_handle;

// The Delaunay triangulation of the larger sample on the surface: in the plane first, then flipped by the
// opposite angles in space, since the plane shows angles truly only where the map is conformal.
class Neighbourhood {
 public:
  Neighbourhood(const AnalyticSurface& surface, const BlueNoise& noise) : points_(noise.draft.points) {
    std::vector<std::pair<Kernel::Point_2, Index>> placed;
    placed.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!surface.in_window(noise.uv[i])) continue;
      const UV at = surface.plane(noise.uv[i]);
      placed.emplace_back(Kernel::Point_2(at.u, at.v), static_cast<Index>(i));
    }
    triangulation_.insert(placed.begin(), placed.end());
    flip_all();
  }

  const Triangulation& triangulation() const { return triangulation_; }

 private:
  const Point& point(Vertex v) const { return points_[v->info()]; }

  double angle_at(Vertex apex, Vertex a, Vertex b) const {
    const Point to_a = point(a) - point(apex), to_b = point(b) - point(apex);
    return std::atan2(norm(cross(to_a, to_b)), dot(to_a, to_b));
  }

  bool turns_left(Vertex a, Vertex b, Vertex c) const {
    return CGAL::orientation(a->point(), b->point(), c->point()) == CGAL::LEFT_TURN;
  }

  // Flips the edge opposite to vertex i where the angles that face it sum to more than pi; the plane stays
  // covered once.
  bool flip(Face face, int i) {
    const Face other = face->neighbor(i);
    if (triangulation_.is_infinite(face) || triangulation_.is_infinite(other)) return false;
    const Vertex p = face->vertex(i), a = face->vertex(Triangulation::ccw(i)),
                 b = face->vertex(Triangulation::cw(i));
    const Vertex q = triangulation_.tds().mirror_vertex(face, i);
    constexpr double tolerance = 1e-9;  // two flips that undo each other would not end
    if (angle_at(p, a, b) + angle_at(q, a, b) <= std::numbers::pi + tolerance) return false;
    if (!turns_left(p, a, q) || !turns_left(q, b, p)) return false;
    triangulation_.tds().flip(face, i);
    return true;
  }

  void flip_all() {
    constexpr int rounds = 50;  // a few do; on a surface no theorem says that flips end
    for (int round = 0; round < rounds; ++round) {
      bool changed = false;
      for (const Face face : triangulation_.finite_face_handles()) {
        for (int i = 0; i < 3; ++i) changed = flip(face, i) || changed;
      }
      if (!changed) return;
    }
  }

  const std::vector<Point>& points_;
  Triangulation triangulation_;
};

class Crop {
 public:
  Crop(const Triangulation& triangulation, std::vector<std::uint8_t> kept)
      : triangulation_(triangulation), kept_(std::move(kept)) {
    drop_all_but_fans();
    keep_largest_piece();
  }

  const std::vector<std::uint8_t>& kept() const { return kept_; }

  // The edges between kept and removed triangles, joined head to tail, with the kept side on the left.
  std::vector<std::vector<Index>> loops() const {
    std::vector<Index> next(kept_.size(), none);
    for (const Face face : triangulation_.finite_face_handles()) {
      if (!keeps(face)) continue;
      for (int i = 0; i < 3; ++i) {
        if (keeps(face->neighbor(i))) continue;
        next[face->vertex(Triangulation::ccw(i))->info()] = face->vertex(Triangulation::cw(i))->info();
      }
    }
    std::vector<std::vector<Index>> loops;
    for (std::size_t start = 0; start < next.size(); ++start) {
      if (next[start] == none) continue;
      auto& loop = loops.emplace_back();
      for (Index i = static_cast<Index>(start); next[i] != none;) {
        loop.push_back(i);
        i = std::exchange(next[i], none);
      }
    }
    return loops;
  }

 private:
  // What lies beyond the hull has lost nothing to the crop.
  bool keeps(Face face) const {
    if (triangulation_.is_infinite(face)) return true;
    return kept_[face->vertex(0)->info()] && kept_[face->vertex(1)->info()] && kept_[face->vertex(2)->info()];
  }

  // Whether the kept triangles at a point form one fan, open or closed.
  bool has_one_fan(Vertex v) const {
    int kept_faces = 0, changes = 0;
    auto face = triangulation_.incident_faces(v);
    const auto first = face;
    do {
      const bool here = keeps(face);
      const auto before = face++;
      kept_faces += here && !triangulation_.is_infinite(Face(before)) ? 1 : 0;
      changes += here != keeps(face) ? 1 : 0;
    } while (face != first);
    return kept_faces > 0 && changes <= 2;
  }

  void drop_all_but_fans() {
    std::deque<Vertex> queue;
    for (const Vertex v : triangulation_.finite_vertex_handles()) queue.push_back(v);
    while (!queue.empty()) {
      const Vertex v = queue.front();
      queue.pop_front();
      if (!kept_[v->info()] || has_one_fan(v)) continue;
      kept_[v->info()] = 0;
      auto around = triangulation_.incident_vertices(v);
      const auto first = around;
      do {
        if (!triangulation_.is_infinite(Vertex(around))) queue.push_back(around);
      } while (++around != first);
    }
  }

  // The kept vertices that kept triangles join to `start`.
  std::vector<Vertex> piece_of(Vertex start, std::vector<std::uint8_t>& seen) const {
    std::vector<Vertex> piece{start};
    seen[start->info()] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      auto face = triangulation_.incident_faces(piece[i]);
      const auto first = face;
      do {
        if (triangulation_.is_infinite(Face(face)) || !keeps(face)) continue;
        for (int j = 0; j < 3; ++j) {
          const Vertex v = face->vertex(j);
          if (!std::exchange(seen[v->info()], 1)) piece.push_back(v);
        }
      } while (++face != first);
    }
    return piece;
  }

  void keep_largest_piece() {
    std::vector<std::uint8_t> seen(kept_.size(), 0);
    std::vector<std::vector<Vertex>> pieces;
    for (const Vertex v : triangulation_.finite_vertex_handles()) {
      if (kept_[v->info()] && !seen[v->info()]) pieces.push_back(piece_of(v, seen));
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      for (const Vertex v : pieces[i]) kept_[v->info()] = 0;
    }
  }

  const Triangulation& triangulation_;
  std::vector<std::uint8_t> kept_;
};

double signed_area(const std::vector<Index>& loop, const AnalyticSurface& surface,
                   const std::vector<UV>& uv) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const UV a = surface.plane(uv[loop[i]]), b = surface.plane(uv[loop[next_in(i, loop.size())]]);
    sum += a.u * b.v - a.v * b.u;
  }
  return sum / 2;
}

// The kept points, numbered anew.
Draft gather(const BlueNoise& noise, const Crop& crop, std::vector<std::vector<Index>> loops) {
  Draft draft;
  std::vector<Index> place(noise.uv.size(), none);
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!crop.kept()[i]) continue;
    place[i] = static_cast<Index>(draft.points.size());
    draft.points.push_back(noise.draft.points[i]);
  }
  for (auto& loop : loops) {
    for (Index& id : loop) id = place[id];
  }
  draft.loops = std::move(loops);
  return draft;
}

}  // namespace

Draft cropped(Shape shape, double spacing, const Run& run, std::size_t expected) {
  constexpr double margin = 3;  // in spacings: no edge of the triangulation is longer than 1.7
  const AnalyticSurface patch = make_surface(shape);
  AnalyticSurface larger = make_surface(shape, margin * spacing);
  larger.rims.clear();
  const BlueNoise noise = blue_noise(larger, {DensityChange::None, spacing}, run, expected);
  const Neighbourhood neighbourhood(larger, noise);
  run.check_cancel();

  std::vector<std::uint8_t> kept(noise.uv.size());
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = patch.depth(noise.uv[i]) > 0 ? 1 : 0;
  const Crop crop(neighbourhood.triangulation(), std::move(kept));
  auto loops = crop.loops();
  std::stable_sort(loops.begin(), loops.end(), [&](const auto& a, const auto& b) {
    return signed_area(a, larger, noise.uv) > signed_area(b, larger, noise.uv);  // holes are negative
  });
  return gather(noise, crop, std::move(loops));
}

}  // namespace rimline
