// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/star.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "parallel.h"
#include "random.h"

namespace rimline::exact {
namespace {

// A corner of the cell, relative to its point, and the neighbour whose bisector is the side that leaves it.
struct Corner {
  double x, y;
  Index side;
};

// Points on one circle (grids) have many Delaunay triangulations, and the stars must agree on one. So each
// point gets a weight far below the spacing squared, from its coordinates alone, and the cells are those of
// the power diagram of these weights: ties are settled the same way in every star.
double tie_weight(Point p, double spacing) {
  std::uint64_t bits = Random(std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y)).next();
  bits = Random(bits, std::bit_cast<std::uint64_t>(p.z)).next();
  return 1e-7 * spacing * spacing * static_cast<double>(bits >> 11) * 0x1p-53;
}

class Cell {
 public:
  explicit Cell(double half_width) {
    corners_ = {{-half_width, -half_width, none},
                {half_width, -half_width, none},
                {half_width, half_width, none},
                {-half_width, half_width, none}};
    measure();
  }

  double radius_squared() const { return radius_squared_; }
  const std::vector<Corner>& corners() const { return corners_; }

  // Keeps a x + b y <= c.
  void cut(double a, double b, double c, Index side) {
    const auto outside = [&](const Corner& p) { return a * p.x + b * p.y > c; };
    if (std::none_of(corners_.begin(), corners_.end(), outside)) return;
    next_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner &p = corners_[i], &q = corners_[i + 1 < corners_.size() ? i + 1 : 0];
      const double at_p = a * p.x + b * p.y - c, at_q = a * q.x + b * q.y - c;
      if (at_p <= 0) next_.push_back(p);
      if ((at_p <= 0) != (at_q <= 0)) {
        const double t = at_p / (at_p - at_q);
        next_.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), at_p <= 0 ? side : p.side});
      }
    }
    corners_.swap(next_);
    measure();
  }

 private:
  void measure() {
    radius_squared_ = 0;
    for (const Corner& p : corners_) radius_squared_ = std::max(radius_squared_, p.x * p.x + p.y * p.y);
  }

  std::vector<Corner> corners_, next_;
  double radius_squared_ = 0;
};

// For each point those that have it in their list without being in its own, as a compressed table.
struct Reverse {
  std::vector<std::size_t> first;
  std::vector<Index> ids;

  std::span<const Index> of(Index i) const { return {ids.data() + first[i], first[i + 1] - first[i]}; }
};

Reverse reverse_only(Points points, const Neighbours& neighbours) {
  const Index n = neighbours.size();
  Reverse reverse;
  reverse.first.assign(points.size() + 1, 0);
  const auto visit = [&](const auto& use) {
    for (Index i = 0; i < n; ++i) {
      const auto ids = neighbours.of(i);
      const auto distances = neighbours.distances_of(i);
      for (int j = 0; j < neighbours.k; ++j) {
        if (distances[j] > neighbours.distances_of(ids[j])[neighbours.k - 1]) use(ids[j], i);
      }
    }
  };
  visit([&](Index of, Index) { ++reverse.first[of + 1]; });
  for (Index i = 0; i < n; ++i) reverse.first[i + 1] += reverse.first[i];
  reverse.ids.resize(reverse.first[n]);
  std::vector<std::size_t> at(reverse.first.begin(), reverse.first.end() - 1);
  visit([&](Index of, Index i) { reverse.ids[at[of]++] = i; });
  return reverse;
}

class StarFinder {
 public:
  StarFinder(Points points, const Neighbours& neighbours, const std::vector<double>& spacing)
      : points_(points), neighbours_(neighbours), spacing_(spacing), weight_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) weight_[i] = tie_weight(points[i], spacing[i]);
    reverse_ = reverse_only(points, neighbours);
  }

  Star star(Index self, const Frame& frame) const {
    constexpr double half_width = 20;  // spacings: far beyond any triangle that can be kept
    Cell cell(half_width * spacing_[self]);
    const auto near = neighbours_.of(self);
    for (const Index other : near) {
      if (!cut(cell, self, other, frame)) break;
    }
    for (const Index other : reverse_.of(self)) cut(cell, self, other, frame);
    Star star;
    for (const Corner& corner : cell.corners()) star.push_back(corner.side);
    return star;
  }

 private:
  // Returns false where the neighbour is too far for its bisector to reach the cell.
  bool cut(Cell& cell, Index self, Index other, const Frame& frame) const {
    constexpr double steepest = 0.75;  // squared sine of 60 degrees: steeper is another sheet
    const Point d = points_[other] - points_[self];
    const double squared = dot(d, d);
    if (squared > 4 * cell.radius_squared()) return false;
    const double height = dot(d, frame.normal);
    if (height * height > steepest * squared) return true;
    const double x = dot(d, frame.u), y = dot(d, frame.v);
    const double scale = std::sqrt(squared / (x * x + y * y));  // the true distance, as if rolled out
    cell.cut(scale * x, scale * y, 0.5 * (squared + weight_[self] - weight_[other]), other);
    return true;
  }

  Points points_;
  const Neighbours& neighbours_;
  const std::vector<double>& spacing_;
  std::vector<double> weight_;
  Reverse reverse_;
};

}  // namespace

std::vector<Star> find_stars(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                             const std::vector<Frame>& frames, const Run& run) {
  const StarFinder finder(points, neighbours, spacing);
  std::vector<Star> stars(points.size());
  parallel_for_each(points.size(), Stage::Boundary, run,
                    [&](Index i) { stars[i] = finder.star(i, frames[i]); });
  return stars;
}

}  // namespace rimline::exact
