// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/star.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "base/model.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "local/own_frame.h"

namespace rimline {
namespace {

// Points on one circle (grids) have many Delaunay triangulations, and the stars must agree on one. So each
// point gets a weight far below the spacing squared, from its place in the cloud's own frame alone, and the
// cells are those of the power diagram of these weights: ties are settled the same way in every star.
double tie_weight(Point p, const OwnFrame& frame, double spacing) {
  const Point at = (1 / spacing) * frame.in(p - frame.centre);
  const double wave = std::sin(17.3 * at.x + 29.9 * at.y + 41.1 * at.z);  // [guard]
  return 5e-8 * spacing * spacing * (1 + wave);                           // [guard] below all that counts
}

// The Voronoi cell of one point after another. Corners are relative to the point, each with the neighbour
// whose bisector is the side that leaves it; a coordinate an array, so that a bisector is held against
// several at once.
class Cell {
 public:
  Cell() { reserve(few); }

  // A square.
  void reset(double half_width) {
    count_ = 4;
    constexpr double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    for (int i = 0; i < 4; ++i) now_.put(i, half_width * x[i], half_width * y[i], none);
    radius_squared_ = 2 * half_width * half_width;
  }

  double radius_squared() const { return radius_squared_; }
  std::span<const Index> sides() const { return {now_.side.data(), count_}; }

  // Keeps a x + b y <= c.
  void cut(double a, double b, double c, Index side) {
    if (count_ > few) return cut_many(a, b, c, side);
    std::uint32_t beyond = 0;  // a bit for each corner that goes
    for (std::size_t i = 0; i < count_; ++i) {
      beyond_[i] = a * now_.x[i] + b * now_.y[i] - c;
      beyond |= static_cast<std::uint32_t>(beyond_[i] > 0) << i;
    }
    if (beyond == 0) return;
    const std::uint32_t all = (std::uint32_t{1} << count_) - 1;
    const std::uint32_t before = beyond << 1 | beyond >> (count_ - 1);  // the bit of the corner before each
    const std::uint32_t first = beyond & ~before & all, kept = before & ~beyond & all;
    // Corners in a row go; all of them, or several rows, where rounding bends a side.
    if (first != 0 && (first & (first - 1)) == 0) {
      cut_row(static_cast<std::size_t>(std::countr_zero(first)),
              static_cast<std::size_t>(std::countr_zero(kept)), side);
    } else {
      clip(side);
    }
  }

 private:
  static constexpr std::size_t few = 16;  // corners of nearly all cells [speed]

  struct Corners {
    std::vector<double> x, y;
    std::vector<Index> side;

    void put(std::size_t i, double at_x, double at_y, Index leaving) {
      x[i] = at_x, y[i] = at_y, side[i] = leaving;
    }
    // Moves the corners from one place on to another: always as many, which spares a loop of unknown length.
    void move(std::size_t from, std::size_t to) {
      move_few(x.data() + from, x.data() + to);
      move_few(y.data() + from, y.data() + to);
      move_few(side.data() + from, side.data() + to);
    }
    template <class Item>
    static void move_few(const Item* from, Item* to) {
      Item items[few];
      std::memcpy(items, from, sizeof(items));
      std::memcpy(to, items, sizeof(items));
    }
  };
  struct Corner {
    double x, y;
  };

  // Where the bisector meets the side from corner i to corner j.
  Corner meet(std::size_t i, std::size_t j) const {
    const double t = beyond_[i] / (beyond_[i] - beyond_[j]);
    return {now_.x[i] + t * (now_.x[j] - now_.x[i]), now_.y[i] + t * (now_.y[j] - now_.y[i])};
  }

  // Cuts off the corners from `first` to the one before `kept`, by way of corner 0 where `kept` is not above.
  void cut_row(std::size_t first, std::size_t kept, Index side) {
    const std::size_t before = first == 0 ? count_ - 1 : first - 1, last = kept == 0 ? count_ - 1 : kept - 1;
    const Corner in = meet(before, first), out = meet(last, kept);
    const Index out_side = now_.side[last];
    if (first < kept) {
      const std::size_t row = kept - first;
      if (first == 0) {  // both new corners lie between the last one and the first that is kept
        now_.move(kept, 1);
        now_.put(0, out.x, out.y, out_side);
        now_.put(count_ - row + 1, in.x, in.y, side);
      } else {
        now_.move(kept, first + 2);
        now_.put(first, in.x, in.y, side);
        now_.put(first + 1, out.x, out.y, out_side);
      }
      count_ = count_ - row + 2;
    } else {
      now_.move(kept, kept == 0 ? 0 : 1);
      if (kept != 0) now_.put(0, out.x, out.y, out_side);
      count_ = first - kept + 2;
      if (kept == 0) {
        now_.put(count_ - 2, in.x, in.y, side);
        now_.put(count_ - 1, out.x, out.y, out_side);
      } else {
        now_.put(count_ - 1, in.x, in.y, side);
      }
    }
    reserve(count_);
    measure();
  }

  // The same as cut(), for any number of corners.
  void cut_many(double a, double b, double c, Index side) {
    double farthest = a * now_.x[0] + b * now_.y[0] - c;
    for (std::size_t i = 0; i < count_; ++i) {
      beyond_[i] = a * now_.x[i] + b * now_.y[i] - c;
      farthest = std::max(farthest, beyond_[i]);
    }
    if (farthest > 0) clip(side);
  }

  // Whichever corners go.
  void clip(Index side) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t j = next_in(i, count_);
      if (beyond_[i] <= 0) next_.put(next++, now_.x[i], now_.y[i], now_.side[i]);
      if ((beyond_[i] <= 0) == (beyond_[j] <= 0)) continue;
      const Corner corner = meet(i, j);
      next_.put(next++, corner.x, corner.y, beyond_[i] <= 0 ? side : now_.side[i]);
    }
    count_ = next;
    std::swap(now_, next_);
    reserve(count_);
    measure();
  }

  // Room for any cut of that many corners: where rounding bends sides it may add half as many.
  void reserve(std::size_t count) {
    if (beyond_.size() >= 2 * count + few) return;
    beyond_.resize(4 * count + few);
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

// The bisectors of a point and a few others, in its tangent plane: those (x, y) with a x + b y = c.
struct Bisectors {
  static constexpr std::size_t most = 8;  // [speed] lanes
  std::array<double, most> a, b, c;
  std::array<double, most> squared;  // distance of the other point
  std::array<double, most> steep;    // not negative where it is on another sheet
};

class StarFinder {
 public:
  StarFinder(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
             const std::vector<Frame>& frames, const Run& run)
      : points_(points), neighbours_(neighbours), spacing_(spacing), frames_(frames), weight_(points.size()) {
    const OwnFrame own = own_frame(points, run);
    parallel_for_each(points.size(), Stage::Survey, run,
                      [&](Index i) { weight_[i] = tie_weight(points[i], own, spacing[i]); });
  }

  // Cuts the cell of a point with its neighbours. Returns whether one of them was too far to reach the cell:
  // then all that are farther are, too.
  bool cut_by_own(Cell& cell, Index self) const {
    constexpr double half_width = 20;  // spacings: far beyond any triangle that can be kept [guard]
    cell.reset(half_width * spacing_[self]);
    return cut_by(cell, self, neighbours_.of(self));
  }

  // The same with others, nearest first.
  bool cut_by(Cell& cell, Index self, std::span<const Index> others) const {
    for (; !others.empty(); others = others.subspan(std::min(Bisectors::most, others.size()))) {
      const std::size_t count = std::min(Bisectors::most, others.size());
      const Bisectors bisectors = bisectors_of(self, others.first(count));
      for (std::size_t i = 0; i < count; ++i) {
        if (bisectors.squared[i] > 4 * cell.radius_squared()) return true;
        if (bisectors.steep[i] > 0) continue;
        cell.cut(bisectors.a[i], bisectors.b[i], bisectors.c[i], others[i]);
      }
    }
    return false;
  }

 private:
  // Several at once, for the roots and quotients of one wait for those of no other.
  Bisectors bisectors_of(Index self, std::span<const Index> others) const {
    constexpr double steepest = model::star_steepest;
    const Frame& frame = frames_[self];
    const Point p = points_[self];
    std::array<double, Bisectors::most> x, y, z, weight;
    for (std::size_t i = 0; i < Bisectors::most; ++i) {
      const Index other = others[std::min(i, others.size() - 1)];
      const Point d = points_[other] - p;
      x[i] = d.x, y[i] = d.y, z[i] = d.z;
      weight[i] = weight_[other];
    }
    Bisectors result;
    for (std::size_t i = 0; i < Bisectors::most; ++i) {
      const double squared = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
      const double height = x[i] * frame.normal.x + y[i] * frame.normal.y + z[i] * frame.normal.z;
      const double u = x[i] * frame.u.x + y[i] * frame.u.y + z[i] * frame.u.z;
      const double v = x[i] * frame.v.x + y[i] * frame.v.y + z[i] * frame.v.z;
      const double scale = std::sqrt(squared / (u * u + v * v));  // the true distance, as if rolled out
      result.a[i] = scale * u;
      result.b[i] = scale * v;
      result.c[i] = 0.5 * (squared + weight_[self] - weight[i]);
      result.squared[i] = squared;
      result.steep[i] = height * height - steepest * squared;
    }
    return result;
  }

  Points points_;
  const Neighbours& neighbours_;
  const std::vector<double>& spacing_;
  const std::vector<Frame>& frames_;
  std::vector<double> weight_;
};

// A point, and one that has it in its list without being in the list of the first.
using OneWay = std::pair<Index, Index>;

// Those of the marked points, by point and then by the other.
std::vector<OneWay> find_one_way(Points points, const Neighbours& neighbours,
                                 const std::vector<std::uint8_t>& marked, const Run& run) {
  auto found =
      parallel_gather<OneWay>(marked.size(), Stage::Survey, run, [&](Index i, std::vector<OneWay>& pairs) {
        for (const Index j : neighbours.of(i)) {
          if (!marked[j]) continue;
          if (distance(points[i], points[j]) > distance_to(points, neighbours, j, neighbours.k - 1))
            pairs.push_back({j, i});
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

constexpr std::size_t points_in_row = 4096;  // [speed]

void append_star(const Cell& cell, std::vector<Index>& ids) {
  ids.insert(ids.end(), cell.sides().begin(), cell.sides().end());
}

}  // namespace

DelaunayStars find_delaunay_stars(Points points, const Neighbours& neighbours,
                                  const std::vector<double>& spacing, const std::vector<Frame>& frames,
                                  const Run& run) {
  const std::size_t count = points.size();
  const StarFinder finder(points, neighbours, spacing, frames, run);
  std::vector<Row> rows((count + points_in_row - 1) / points_in_row);
  std::vector<std::uint32_t> size(count);
  std::vector<std::uint8_t> is_open(count, 0);
  const auto for_each_row = [&](const auto& body) {
    parallel_slices(
        rows.size(), Stage::Survey, run,
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
  const std::vector<OneWay> one_way = find_one_way(points, neighbours, is_open, run);
  std::vector<Row> open_rows(rows.size());
  for_each_row([&](Row& row, Index first, Index) {
    Cell cell;
    for (const Index i : row.open) {
      finder.cut_by_own(cell, i);
      auto other = std::lower_bound(one_way.begin(), one_way.end(), OneWay{i, 0});
      for (; other != one_way.end() && other->first == i; ++other)
        finder.cut_by(cell, i, {&other->second, 1});
      append_star(cell, open_rows[first / points_in_row].ids);
      size[i] = static_cast<std::uint32_t>(cell.sides().size());
    }
  });

  std::vector<std::size_t> start(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) start[i + 1] = start[i] + size[i];
  UnfilledVector<Index> ids(start[count]);
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

}  // namespace rimline
