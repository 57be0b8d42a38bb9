// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/star.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "parallel.h"
#include "random.h"

namespace rimline::exact {
namespace {

// Points on one circle (grids) have many Delaunay triangulations, and the stars must agree on one. So each
// point gets a weight far below the spacing squared, from its coordinates alone, and the cells are those of
// the power diagram of these weights: ties are settled the same way in every star.
double tie_weight(Point p, double spacing) {
  std::uint64_t bits = Random(std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y)).next();
  bits = Random(bits, std::bit_cast<std::uint64_t>(p.z)).next();
  return 1e-7 * spacing * spacing * static_cast<double>(bits >> 11) * 0x1p-53;
}

// The Voronoi cell of one point after another. Corners are relative to the point, each with the neighbour
// whose bisector is the side that leaves it; a coordinate an array, so that a bisector is held against
// several at once.
class Cell {
 public:
  // A square.
  void reset(double half_width) {
    reserve(4);
    count_ = 4;
    constexpr double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    for (int i = 0; i < 4; ++i) now_.put(i, half_width * x[i], half_width * y[i], none);
    measure();
  }

  double radius_squared() const { return radius_squared_; }
  std::span<const Index> sides() const { return {now_.side.data(), count_}; }

  // Keeps a x + b y <= c.
  void cut(double a, double b, double c, Index side) {
    for (std::size_t i = 0; i < count_; ++i) beyond_[i] = a * now_.x[i] + b * now_.y[i] - c;
    double farthest = beyond_[0];
    for (std::size_t i = 1; i < count_; ++i) farthest = std::max(farthest, beyond_[i]);
    if (!(farthest > 0)) return;
    reserve(count_ + 2);
    std::size_t next = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t j = i + 1 < count_ ? i + 1 : 0;
      const double at_i = beyond_[i], at_j = beyond_[j];
      if (at_i <= 0) next_.put(next++, now_.x[i], now_.y[i], now_.side[i]);
      if ((at_i <= 0) == (at_j <= 0)) continue;
      const double t = at_i / (at_i - at_j);
      next_.put(next++, now_.x[i] + t * (now_.x[j] - now_.x[i]), now_.y[i] + t * (now_.y[j] - now_.y[i]),
                at_i <= 0 ? side : now_.side[i]);
    }
    count_ = next;
    std::swap(now_, next_);
    measure();
  }

 private:
  struct Corners {
    std::vector<double> x, y;
    std::vector<Index> side;

    void put(std::size_t i, double at_x, double at_y, Index leaving) {
      x[i] = at_x, y[i] = at_y, side[i] = leaving;
    }
  };

  // Rounding may bend a side, so that a cut could add more than one corner: twice as many are room enough.
  void reserve(std::size_t count) {
    if (beyond_.size() >= 2 * count) return;
    beyond_.resize(4 * count);
    for (Corners* corners : {&now_, &next_}) {
      corners->x.resize(beyond_.size());
      corners->y.resize(beyond_.size());
      corners->side.resize(beyond_.size());
    }
  }
  void measure() {
    radius_squared_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      radius_squared_ = std::max(radius_squared_, now_.x[i] * now_.x[i] + now_.y[i] * now_.y[i]);
    }
  }

  std::size_t count_ = 0;
  Corners now_, next_;
  std::vector<double> beyond_;
  double radius_squared_ = 0;
};

class StarFinder {
 public:
  StarFinder(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
             const std::vector<Frame>& frames, const Run& run)
      : points_(points), neighbours_(neighbours), spacing_(spacing), frames_(frames), weight_(points.size()) {
    parallel_for_each(points.size(), Stage::Boundary, run,
                      [&](Index i) { weight_[i] = tie_weight(points[i], spacing[i]); });
  }

  // Cuts the cell of a point with its neighbours. Returns whether one of them was too far to reach the cell:
  // then all that are farther are, too.
  bool cut_by_own(Cell& cell, Index self) const {
    constexpr double half_width = 20;  // spacings: far beyond any triangle that can be kept
    cell.reset(half_width * spacing_[self]);
    for (const Index other : neighbours_.of(self)) {
      if (!cut(cell, self, other)) return true;
    }
    return false;
  }

  // Returns false where the other is too far for its bisector to reach the cell.
  bool cut(Cell& cell, Index self, Index other) const {
    constexpr double steepest = 0.75;  // squared sine of 60 degrees: steeper is another sheet
    const Frame& frame = frames_[self];
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

 private:
  Points points_;
  const Neighbours& neighbours_;
  const std::vector<double>& spacing_;
  const std::vector<Frame>& frames_;
  std::vector<double> weight_;
};

// A point, and one that has it in its list without being in the list of the first.
using OneWay = std::pair<Index, Index>;

// Those of the marked points, by point and then by the other.
std::vector<OneWay> find_one_way(const Neighbours& neighbours, const std::vector<std::uint8_t>& marked,
                                 const Run& run) {
  auto found =
      parallel_gather<OneWay>(marked.size(), Stage::Boundary, run, [&](Index i, std::vector<OneWay>& pairs) {
        const auto ids = neighbours.of(i);
        for (int j = 0; j < neighbours.k; ++j) {
          if (!marked[ids[j]]) continue;
          if (neighbours.distances_of(i)[j] > neighbours.distances_of(ids[j])[neighbours.k - 1])
            pairs.push_back({ids[j], i});
        }
      });
  std::sort(found.begin(), found.end());
  return found;
}

// Stars of points in a row.
struct Row {
  std::vector<Index> ids;
  std::vector<Index>
      open;  // the points whose lists end within reach of their cells; their stars are left out
};

constexpr std::size_t points_in_row = 4096;

void append_star(const Cell& cell, std::vector<Index>& ids) {
  ids.insert(ids.end(), cell.sides().begin(), cell.sides().end());
}

}  // namespace

Stars find_stars(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                 const std::vector<Frame>& frames, const Run& run) {
  const std::size_t count = points.size();
  const StarFinder finder(points, neighbours, spacing, frames, run);
  std::vector<Row> rows((count + points_in_row - 1) / points_in_row);
  std::vector<std::uint32_t> size(count);
  std::vector<std::uint8_t> is_open(count, 0);
  const auto for_each_row = [&](const auto& body) {
    parallel_slices(
        rows.size(), Stage::Boundary, run,
        [&](std::size_t first, std::size_t last) {
          for (std::size_t r = first; r < last; ++r) {
            body(rows[r], static_cast<Index>(r * points_in_row),
                 static_cast<Index>(std::min(count, (r + 1) * points_in_row)));
          }
        },
        1);
  };
  for_each_row([&](Row& row, Index first, Index last) {
    Cell cell;
    for (Index i = first; i < last; ++i) {
      if (finder.cut_by_own(cell, i)) {
        append_star(cell, row.ids);
        size[i] = static_cast<std::uint32_t>(cell.sides().size());
      } else {
        row.open.push_back(i);
        is_open[i] = 1;
      }
    }
  });

  // Only where the own list ends too early can those who have the point in theirs cut its cell: they are
  // farther than all of the list.
  const std::vector<OneWay> one_way = find_one_way(neighbours, is_open, run);
  std::vector<Row> open_rows(rows.size());
  for_each_row([&](Row& row, Index first, Index) {
    Cell cell;
    for (const Index i : row.open) {
      finder.cut_by_own(cell, i);
      auto other = std::lower_bound(one_way.begin(), one_way.end(), OneWay{i, 0});
      for (; other != one_way.end() && other->first == i; ++other) finder.cut(cell, i, other->second);
      append_star(cell, open_rows[first / points_in_row].ids);
      size[i] = static_cast<std::uint32_t>(cell.sides().size());
    }
  });

  std::vector<std::size_t> start(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) start[i + 1] = start[i] + size[i];
  std::vector<Index> ids(start[count]);
  for_each_row([&](Row& row, Index first, Index last) {
    auto closed = row.ids.begin(), open = open_rows[first / points_in_row].ids.begin();
    for (Index i = first; i < last; ++i) {
      auto& from = is_open[i] ? open : closed;
      std::copy_n(from, size[i], ids.begin() + start[i]);
      from += size[i];
    }
    row = {};
  });
  return {std::move(start), std::move(ids)};
}

}  // namespace rimline::exact
