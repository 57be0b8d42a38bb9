// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/compaction.h"
#include "base/model.h"
#include "base/parallel.h"
#include "base/prefault.h"
#include "base/vec.h"

namespace rimline {

double circumradius(Point a, Point b, Point c) {
  const double twice_area = norm(triangle_normal(a, b, c));
  if (twice_area <= 0) return std::numeric_limits<double>::infinity();
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * twice_area);
}

double angle_at(Point a, Point b, Point c) {
  const Point to_a = a - b, to_c = c - b;
  return std::atan2(norm(cross(to_a, to_c)), dot(to_a, to_c));
}

TriangleSet::AtVertices::AtVertices(const Stars& stars, const Run& run) : stars_(stars) {
  resize_together(places_, stars.size(), run);
  const std::size_t places = stars.start(stars.size());
  resize_together(ids_, places, run, places / 8);  // [speed]
  parallel_for_each(stars.size(), Stage::Survey, run, [&](Index v) {
    const auto room = static_cast<std::uint32_t>(stars[v].size());
    places_[v] = {stars.start(v), room, room};
    std::fill_n(ids_.begin() + static_cast<std::ptrdiff_t>(stars.start(v)), room, none);
  });
}

void TriangleSet::start_with(std::vector<Triangle> triangles, std::vector<double> radii, AtVertices at,
                             const Run& run) {
  mesh_.triangles = std::move(triangles);
  radii_ = std::move(radii);
  stars_ = std::move(at.places_);
  at_vertex_ = std::move(at.ids_);
  const std::size_t count = mesh_.triangles.size();
  resize_together(mesh_.adjacent, count, run, mesh_.triangles.capacity() - count);
  parallel_for_each(count, Stage::Survey, run, [&](Index t) { mesh_.adjacent[t].fill(none); });
  parallel_for_each(stars_.size(), Stage::Survey, run, [&](Index v) {
    link_at_vertex(v, at.stars_[v]);
    gather_at_vertex(v);
  });
}

// Removes the entries that hold no triangle.
void TriangleSet::gather_at_vertex(Index vertex) {
  Place& place = stars_[vertex];
  const auto first = at_vertex_.begin() + static_cast<std::ptrdiff_t>(place.first);
  const auto last = std::remove(first, first + place.count, none);
  std::sort(first, last);
  place.count = static_cast<std::uint32_t>(last - first);
}

// Links the triangles on both sides of each edge to a vertex of higher id; the other end does not. Two
// triangles with a common edge are at consecutive corners of the star.
void TriangleSet::link_at_vertex(Index vertex, Star star) {
  const Index* at = at_vertex_.data() + stars_[vertex].first;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const std::size_t next = next_in(i, star.size());
    if (star[next] < vertex || at[i] == none || at[next] == none || i == next) continue;
    mesh_.adjacent[at[i]][mesh_.corner_opposite(at[i], vertex, star[next])] = at[next];
    mesh_.adjacent[at[next]][mesh_.corner_opposite(at[next], vertex, star[next])] = at[i];
  }
}

void TriangleSet::put_at_vertex(Index vertex, Index triangle) {
  Place& place = stars_[vertex];
  if (place.count == place.room) {  // moves to the end, with twice the room
    const std::size_t first = at_vertex_.size();
    place.room = std::max(8u, 2 * place.room);  // [speed]
    at_vertex_.resize(first + place.room, none);
    std::copy_n(at_vertex_.begin() + place.first, place.count, at_vertex_.begin() + first);
    place.first = first;
  }
  at_vertex_[place.first + place.count++] = triangle;
}

void TriangleSet::add(const Triangle& triangle) {
  const Index id = size();
  std::array<Index, 3> adjacent{none, none, none};
  for (int c = 0; c < 3; ++c) {
    const Index a = triangle[next(c)], b = triangle[previous(c)];
    Index found[2];
    if (edge(a, b, found) != 1) continue;
    Index& back = mesh_.adjacent[found[0]][mesh_.corner_opposite(found[0], a, b)];
    if (back != none) continue;
    adjacent[c] = found[0];
    back = id;
  }
  for (const Index v : triangle) put_at_vertex(v, id);
  mesh_.triangles.push_back(triangle);
  mesh_.adjacent.push_back(adjacent);
  radii_.push_back(circumradius(points_[triangle[0]], points_[triangle[1]], points_[triangle[2]]));
}

void TriangleSet::keep_only(const std::vector<std::uint8_t>& kept, const Run& run) {
  const KeptItems stay(kept, Stage::Loops, run);
  if (stay.is_all()) return;
  const UnfilledVector<Index> id = stay.places();
  const auto renumber = [&](Index t) { return t == none ? none : id[t]; };
  parallel_for_each(stars_.size(), Stage::Loops, run, [&](Index v) {
    Place& place = stars_[v];
    const auto first = at_vertex_.begin() + static_cast<std::ptrdiff_t>(place.first);
    const auto last = std::transform(first, first + place.count, first, renumber);
    place.count = static_cast<std::uint32_t>(std::remove(first, last, none) - first);
  });
  const auto move_up = [&](auto& items, const auto& changed) {
    for (std::size_t t = 0; t < items.size(); ++t) {
      if (id[t] != none) items[id[t]] = changed(items[t]);
    }
    items.resize(stay.size());
  };
  const auto as_it_is = [](const auto& item) { return item; };
  parallel_tasks(3, Stage::Loops, run, [&](std::size_t k) {
    if (k == 0) move_up(mesh_.triangles, as_it_is);
    if (k == 1) {
      move_up(mesh_.adjacent, [&](const std::array<Index, 3>& adjacent) {
        return std::array{renumber(adjacent[0]), renumber(adjacent[1]), renumber(adjacent[2])};
      });
    }
    if (k == 2) move_up(radii_, as_it_is);
  });
  run.check_cancel();
}

int TriangleSet::edge(Index a, Index b, Index (&found)[2]) const {
  int count = 0;
  for (const Index t : star(a)) {
    const Triangle& x = mesh_.triangles[t];
    if ((x[0] == b || x[1] == b || x[2] == b) && count < 2) found[count++] = t;
  }
  return count;
}

bool TriangleSet::can_add(const Triangle& triangle) const {
  for (int i = 0; i < 3; ++i) {
    const Index a = triangle[i], b = triangle[next_in(i, 3)], c = triangle[(i + 2) % 3];
    Index found[2];
    const int count = edge(a, b, found);
    if (count == 2) return false;
    if (count == 1) {
      const Index d = apex(found[0], a, b);
      if (d == c || folds_back(a, b, c, d)) return false;
    }
  }
  for (int i = 0; i < 3; ++i) {
    if (!fits_around(triangle[i], triangle[next_in(i, 3)], triangle[(i + 2) % 3])) return false;
  }
  return true;
}

// Whether triangles abc and abd meet at less than 60 degrees at their edge ab.
bool TriangleSet::folds_back(Index a, Index b, Index c, Index d) const {
  const Point e = points_[b] - points_[a];
  const auto off_edge = [&](Index v) {
    const Point x = points_[v] - points_[a];
    return x - (dot(x, e) / dot(e, e)) * e;
  };
  const Point x = off_edge(c), y = off_edge(d);
  return dot(x, y) > model::folds_back * norm(x) * norm(y);
}

double TriangleSet::direction(Index from, Index to) const {
  const Point d = points_[to] - points_[from];
  const Frame& f = (*frames_)[from];
  return std::atan2(dot(d, f.v), dot(d, f.u));
}

// Whether the corner between a and b at the vertex does not overlap other corners there, in the tangent
// plane.
bool TriangleSet::fits_around(Index vertex, Index a, Index b) const {
  constexpr double turn = 2 * std::numbers::pi, overlap = model::corner_overlap;
  if (star(vertex).empty()) return true;
  if (closes_beside_others(vertex, a, b)) return false;
  const auto corner = [&](Index x, Index y, double& middle, double& half) {
    const double from = direction(vertex, x), step = std::remainder(direction(vertex, y) - from, turn);
    middle = from + step / 2;
    half = std::abs(step) / 2;
  };
  double middle, half, other_middle, other_half;
  corner(a, b, middle, half);
  for (const Index t : star(vertex)) {
    const Triangle& x = mesh_.triangles[t];
    const int at = x[0] == vertex ? 0 : x[1] == vertex ? 1 : 2;
    corner(x[next_in(at, 3)], x[(at + 2) % 3], other_middle, other_half);
    if (std::abs(std::remainder(middle - other_middle, turn)) < half + other_half - overlap) return false;
  }
  return true;
}

// Whether a corner between a and b would close a fan all around while another fan exists.
bool TriangleSet::closes_beside_others(Index vertex, Index a, Index b) const {
  std::size_t steps = 0;
  Index at = a, found[2];
  for (Index t = edge(vertex, a, found) > 0 ? found[0] : none; t != none; t = across(t, vertex, at)) {
    at = apex(t, vertex, at);
    if (++steps > star(vertex).size()) return true;
  }
  return at == b && steps > 0 && steps != star(vertex).size();
}

}  // namespace rimline
