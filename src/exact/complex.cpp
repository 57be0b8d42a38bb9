// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/complex.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace rimline::exact {

double circumradius(Point a, Point b, Point c) {
  const double twice_area = norm(cross(b - a, c - a));
  if (twice_area <= 0) return std::numeric_limits<double>::infinity();
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * twice_area);
}

void Complex::add(const Triangle& triangle) {
  for (const Index v : triangle) stars_[v].push_back(size());
  triangles_.push_back(triangle);
  radii_.push_back(circumradius(points_[triangle[0]], points_[triangle[1]], points_[triangle[2]]));
}

void Complex::keep_only(const std::vector<std::uint8_t>& kept) {
  const std::vector<Triangle> before = std::move(triangles_);
  triangles_.clear();
  radii_.clear();
  for (auto& star : stars_) star.clear();
  for (std::size_t t = 0; t < before.size(); ++t) {
    if (kept[t]) add(before[t]);
  }
}

int Complex::edge(Index a, Index b, Index (&found)[2]) const {
  int count = 0;
  for (const Index t : stars_[a]) {
    const Triangle& x = triangles_[t];
    if ((x[0] == b || x[1] == b || x[2] == b) && count < 2) found[count++] = t;
  }
  return count;
}

Index Complex::across(Index triangle, Index a, Index b) const {
  Index found[2];
  const int count = edge(a, b, found);
  for (int i = 0; i < count; ++i) {
    if (found[i] != triangle) return found[i];
  }
  return none;
}

Index Complex::apex(Index triangle, Index a, Index b) const {
  for (const Index v : triangles_[triangle]) {
    if (v != a && v != b) return v;
  }
  return none;
}

bool Complex::can_add(const Triangle& triangle) const {
  for (int i = 0; i < 3; ++i) {
    const Index a = triangle[i], b = triangle[(i + 1) % 3], c = triangle[(i + 2) % 3];
    Index found[2];
    const int count = edge(a, b, found);
    if (count == 2) return false;
    if (count == 1) {
      const Index d = apex(found[0], a, b);
      if (d == c || folds_back(a, b, c, d)) return false;
    }
  }
  for (int i = 0; i < 3; ++i) {
    if (!fits_around(triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3])) return false;
  }
  return true;
}

// Whether triangles abc and abd meet at less than 60 degrees at their edge ab.
bool Complex::folds_back(Index a, Index b, Index c, Index d) const {
  const Point e = points_[b] - points_[a];
  const auto off_edge = [&](Index v) {
    const Point x = points_[v] - points_[a];
    return x - (dot(x, e) / dot(e, e)) * e;
  };
  const Point x = off_edge(c), y = off_edge(d);
  return dot(x, y) > 0.5 * norm(x) * norm(y);
}

double Complex::direction(Index from, Index to) const {
  const Point d = points_[to] - points_[from];
  const Frame& f = frames_[from];
  return std::atan2(dot(d, f.v), dot(d, f.u));
}

// Whether the corner between a and b at the vertex leaves the other corners there alone, seen in its plane.
bool Complex::fits_around(Index vertex, Index a, Index b) const {
  constexpr double turn = 2 * std::numbers::pi, overlap = 0.1;  // radians that corners may overlap by
  if (stars_[vertex].empty()) return true;
  if (closes_beside_others(vertex, a, b)) return false;
  const auto corner = [&](Index x, Index y, double& middle, double& half) {
    const double from = direction(vertex, x), step = std::remainder(direction(vertex, y) - from, turn);
    middle = from + step / 2;
    half = std::abs(step) / 2;
  };
  double middle, half, other_middle, other_half;
  corner(a, b, middle, half);
  for (const Index t : stars_[vertex]) {
    const Triangle& x = triangles_[t];
    const int at = x[0] == vertex ? 0 : x[1] == vertex ? 1 : 2;
    corner(x[(at + 1) % 3], x[(at + 2) % 3], other_middle, other_half);
    if (std::abs(std::remainder(middle - other_middle, turn)) < half + other_half - overlap) return false;
  }
  return true;
}

// Whether a corner between a and b would close a fan all around while another fan exists.
bool Complex::closes_beside_others(Index vertex, Index a, Index b) const {
  std::size_t steps = 0;
  Index at = a;
  for (Index t = across(none, vertex, a); t != none; t = across(t, vertex, at)) {
    at = apex(t, vertex, at);
    if (++steps > stars_[vertex].size()) return true;
  }
  return at == b && steps > 0 && steps != stars_[vertex].size();
}

}  // namespace rimline::exact
