// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/star.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/model.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "local/own_frame.h"
#include "local/voronoi_cell.h"

namespace rimline {
namespace {

// Cocircular points (grids) have many Delaunay triangulations, and the stars must agree on one. So each point
// gets a weight far below the squared spacing, from its position in the cloud's own frame, and the cells are
// those of the power diagram of these weights. Ties are broken the same way in every star.
double tie_weight(Point p, const OwnFrame& frame, double spacing) {
  const Point at = (1 / spacing) * frame.in(p - frame.centre);
  const double wave = std::sin(17.3 * at.x + 29.9 * at.y + 41.1 * at.z);  // [guard]
  return 5e-8 * spacing * spacing * (1 + wave);                           // [guard] below all that counts
}

// The bisectors of a point and a few others, in its tangent plane: those (x, y) with a x + b y = c.
struct Bisectors {
  static constexpr std::size_t most = 8;  // [speed] lanes
  std::array<double, most> a, b, c;
  std::array<double, most> squared;  // distance of the other point
  std::array<double, most> steep;    // not negative where it is on another sheet
};

// The extent of a cell where no neighbour bounds it.
enum class Reach {
  Far,        // 20 spacings: farther than any triangle that can be kept
  WithinList  // distance of the last neighbour
};

class CellCutter {
 public:
  CellCutter(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
             const std::vector<Frame>& frames, Reach reach, const Run& run)
      : points_(points),
        neighbours_(neighbours),
        spacing_(spacing),
        frames_(frames),
        reach_(reach),
        weight_(points.size()) {
    const OwnFrame own = own_frame(points, run);
    parallel_for_each(points.size(), Stage::Survey, run,
                      [&](Index i) { weight_[i] = tie_weight(points[i], own, spacing[i]); });
  }

  // Cuts the cell of a point by its neighbours. Returns whether no other point can cut it: one of the
  // neighbours was too far, and all that are farther are, too.
  bool cut_by_own(VoronoiCell& cell, Index self) const {
    constexpr double far = 20;  // spacings [guard]
    const bool is_far = reach_ == Reach::Far;
    cell.reset(is_far ? far * spacing_[self] : distance_to(points_, neighbours_, self, neighbours_.k - 1));
    return cut_by(cell, self, neighbours_.of(self)) || !is_far;
  }

  // The same with others, nearest first.
  bool cut_by(VoronoiCell& cell, Index self, std::span<const Index> others) const {
    for (; !others.empty(); others = others.subspan(std::min(Bisectors::most, others.size()))) {
      const std::size_t count = std::min(Bisectors::most, others.size());
      const Bisectors bisectors = bisectors_of(self, others.first(count));
      for (std::size_t i = 0; i < count; ++i) {
        if (cell.is_settled(bisectors.squared[i])) return true;
        if (bisectors.steep[i] > 0) continue;
        cell.cut(bisectors.a[i], bisectors.b[i], bisectors.c[i], others[i]);
      }
    }
    return false;
  }

  // Weight of a side of a cell: its length over the distance of the neighbour beyond it; 0 where there is
  // none.
  double weight(const VoronoiCell& cell, Index self, std::size_t side) const {
    const Index beyond = cell.sides()[side];
    return beyond == none ? 0 : cell.side_length(side) / distance(points_[self], points_[beyond]);
  }

 private:
  // Several at once: the square roots and quotients of one do not wait for those of another.
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
      const double scale =
          std::sqrt(squared / (u * u + v * v));  // the true distance, as if the surface were unrolled
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
  Reach reach_;
  std::vector<double> weight_;
};

// A point i, and a point that has i in its list without being in the list of i.
using OneWay = std::pair<Index, Index>;

// The pairs of the marked points, sorted.
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

// Stars of a block of points.
struct Row {
  std::vector<Index> ids;
  std::vector<double> weights;
  std::vector<Index>
      open;  // the points whose lists end within reach of their cells; their stars are left out
};

constexpr std::size_t points_in_row = 4096;  // [speed]

// Calls body(r, first, last) for each row r of the points from `first` to `last` - 1.
template <class Body>
void for_each_row(std::size_t points, const Run& run, const Body& body) {
  const std::size_t rows = (points + points_in_row - 1) / points_in_row;
  const auto body_of_row = [&](std::size_t r) {
    body(r, static_cast<Index>(r * points_in_row),
         static_cast<Index>(std::min(points, (r + 1) * points_in_row)));
  };
  parallel_slices(
      rows, Stage::Survey, run,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t r = first; r < last; ++r) body_of_row(r);
      },
      1);
}

class StarFinder {
 public:
  StarFinder(const CellCutter& cutter, Points points, const Neighbours& neighbours, bool with_weights,
             const Run& run)
      : cutter_(cutter),
        points_(points),
        neighbours_(neighbours),
        with_weights_(with_weights),
        run_(run),
        closed_((points.size() + points_in_row - 1) / points_in_row),
        open_(closed_.size()),
        size_(points.size()),
        is_open_(points.size(), 0) {}

  Stars find() {
    cut_by_own_lists();
    cut_open_ones();
    return gathered();
  }

 private:
  void append(const VoronoiCell& cell, Index self, Row& row) {
    row.ids.insert(row.ids.end(), cell.sides().begin(), cell.sides().end());
    size_[self] = static_cast<std::uint32_t>(cell.sides().size());
    if (!with_weights_) return;
    for (std::size_t side = 0; side < cell.sides().size(); ++side)
      row.weights.push_back(cutter_.weight(cell, self, side));
  }

  void cut_by_own_lists() {
    for_each_row(points_.size(), run_, [&](std::size_t r, Index first, Index last) {
      VoronoiCell cell;
      for (Index i = first; i < last; ++i) {
        if (cutter_.cut_by_own(cell, i)) {
          append(cell, i, closed_[r]);
        } else {
          closed_[r].open.push_back(i);
          is_open_[i] = 1;
        }
      }
    });
  }

  // Points that have the point in their list, without being in its own list, are farther than all of the
  // list. They can cut the cell only where the list ends before the cell is settled.
  void cut_open_ones() {
    const std::vector<OneWay> one_way = find_one_way(points_, neighbours_, is_open_, run_);
    for_each_row(points_.size(), run_, [&](std::size_t r, Index, Index) {
      VoronoiCell cell;
      for (const Index i : closed_[r].open) {
        cutter_.cut_by_own(cell, i);
        auto other = std::lower_bound(one_way.begin(), one_way.end(), OneWay{i, 0});
        for (; other != one_way.end() && other->first == i; ++other)
          cutter_.cut_by(cell, i, {&other->second, 1});
        append(cell, i, open_[r]);
      }
    });
  }

  // Joins the blocks into one array, in the order of the points.
  Stars gathered() {
    std::vector<std::size_t> start(points_.size() + 1, 0);
    for (std::size_t i = 0; i < points_.size(); ++i) start[i + 1] = start[i] + size_[i];
    UnfilledVector<Index> ids(start.back());
    UnfilledVector<double> weights(with_weights_ ? start.back() : 0);
    for_each_row(points_.size(), run_, [&](std::size_t r, Index first, Index last) {
      std::size_t closed = 0, open = 0;  // places in the row's arrays
      for (Index i = first; i < last; ++i) {
        const Row& from = is_open_[i] ? open_[r] : closed_[r];
        std::size_t& at = is_open_[i] ? open : closed;
        std::copy_n(from.ids.begin() + static_cast<std::ptrdiff_t>(at), size_[i], ids.begin() + start[i]);
        if (with_weights_)
          std::copy_n(from.weights.begin() + static_cast<std::ptrdiff_t>(at), size_[i],
                      weights.begin() + start[i]);
        at += size_[i];
      }
      closed_[r] = {};
    });
    return {std::move(start), std::move(ids), std::move(weights)};
  }

  const CellCutter& cutter_;
  Points points_;
  const Neighbours& neighbours_;
  bool with_weights_;
  const Run& run_;
  std::vector<Row> closed_, open_;
  std::vector<std::uint32_t> size_;
  std::vector<std::uint8_t> is_open_;
};

}  // namespace

Stars find_stars(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                 const std::vector<Frame>& frames, const Run& run) {
  const CellCutter cutter(points, neighbours, spacing, frames, Reach::Far, run);
  return StarFinder(cutter, points, neighbours, false, run).find();
}

Stars find_weighted_stars(Points points, const Neighbours& neighbours, const Run& run) {
  const Run silent = run.without_progress();  // it is part of the caller's stage
  const std::vector<double> spacing = local_spacing(points, neighbours, silent);
  std::vector<Frame> frames(points.size());
  parallel_for_each(points.size(), Stage::Survey, silent, [&](Index i) {
    constexpr int few = 10;  // neighbours, before those on other sheets are left out [option]
    frames[i] = fit_frame(points, neighbours.of(i, std::min(few, neighbours.k)), i);
  });
  const CellCutter cutter(points, neighbours, spacing, frames, Reach::WithinList, silent);
  return StarFinder(cutter, points, neighbours, true, silent).find();
}

}  // namespace rimline
