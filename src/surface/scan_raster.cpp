// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/scan_raster.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "base/model.h"
#include "base/parallel.h"
#include "base/quantile.h"
#include "base/vec.h"

namespace rimline {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The samples by their cells.
class Raster {
 public:
  explicit Raster(const std::vector<RasterCell>& cells) : cells_(cells), order_(cells.size()) {
    std::iota(order_.begin(), order_.end(), Index{0});
    std::ranges::sort(order_, {}, [&](Index i) { return key(cells_[i]); });
    last_column_ = cells_[order_.back()].column;
    first_column_ = cells_[order_.front()].column;
  }

  bool has_two_in_a_cell() const {
    return std::ranges::adjacent_find(order_, {}, [&](Index i) { return key(cells_[i]); }) != order_.end();
  }

  void close_turn() { is_closed_ = true; }
  Index first_column() const { return first_column_; }
  Index last_column() const { return last_column_; }

  // The sample that many columns and rows (-1 to 1) from a cell, or `none`.
  Index at(RasterCell from, int columns, int rows) const {
    RasterCell cell{from.column + columns, from.row + rows};
    if (is_closed_ && cell.column > last_column_) cell.column = first_column_;
    if (is_closed_ && cell.column < first_column_) cell.column = last_column_;
    const auto found =
        std::ranges::lower_bound(order_, key(cell), {}, [&](Index i) { return key(cells_[i]); });
    return found != order_.end() && key(cells_[*found]) == key(cell) ? *found : none;
  }
  Index at(Index from, int columns, int rows) const { return at(cells_[from], columns, rows); }
  const RasterCell& cell(Index i) const { return cells_[i]; }

 private:
  static std::pair<Index, Index> key(const RasterCell& cell) { return {cell.column, cell.row}; }

  const std::vector<RasterCell>& cells_;
  std::vector<Index> order_;
  Index first_column_ = 0, last_column_ = 0;
  bool is_closed_ = false;
};

double length(Points points, Index a, Index b) {
  return a == none || b == none ? infinite : distance(points[a], points[b]);
}

// The median of what is finite; infinite where nothing is.
double finite_median(std::vector<double> values) {
  std::erase(values, infinite);
  return values.empty() ? infinite : median(std::move(values));
}

// Steps of the scanner, as they are at each sample.
struct Steps {
  double column_unit = 1;          // a step from column to column, in steps from row to row
  std::vector<double> at;          // from row to row, in the unit of the points
  std::vector<double> to_nearest;  // of the samples beside each in the raster, in the same
};

Steps measure_steps(Points points, const Raster& raster, const Run& run) {
  const std::size_t n = points.size();
  Steps steps{1, std::vector<double>(n), std::vector<double>(n)};
  std::vector<double> row_step(n), column_step(n), ratio(n), least(n);
  parallel_for_each(n, Stage::Survey, run, [&](Index i) {
    const auto to = [&](int columns, int rows) { return length(points, i, raster.at(i, columns, rows)); };
    row_step[i] = std::min(to(0, -1), to(0, 1));
    column_step[i] = std::min(to(-1, 0), to(1, 0));
    const bool both = row_step[i] < infinite && column_step[i] < infinite;
    ratio[i] = both ? column_step[i] / row_step[i] : infinite;
    steps.to_nearest[i] = std::min(row_step[i], column_step[i]);
  });
  if (const double unit = finite_median(std::move(ratio)); unit < infinite) steps.column_unit = unit;
  for (std::size_t i = 0; i < n; ++i) least[i] = std::min(row_step[i], column_step[i] / steps.column_unit);
  parallel_for_each(n, Stage::Survey, run, [&](Index i) {
    std::vector<double> around;
    for (int columns = -1; columns <= 1; ++columns) {
      for (int rows = -1; rows <= 1; ++rows) {
        const Index beside = raster.at(i, columns, rows);
        if (beside != none) around.push_back(least[beside]);
      }
    }
    steps.at[i] = finite_median(std::move(around));
  });
  return steps;
}

// Whether samples that lie beside each other in the raster do so in space.
bool fits(Points points, const Neighbours& neighbours, const Steps& steps) {
  std::size_t near = 0;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
    near +=
        steps.to_nearest[i] <= model::range_cell_largest * distance(points[i], points[neighbours.of(i)[0]]);
  return static_cast<double>(near) >= model::range_cell_share * static_cast<double>(points.size());
}

// Whether the last column lies beside the first one: in the median over the rows, no more than twice a step
// from column to column away.
bool is_full_turn(Points points, const Raster& raster, const Steps& steps) {
  std::vector<double> gaps;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    if (raster.cell(i).column != raster.last_column()) continue;
    const Index beside = raster.at({raster.first_column(), raster.cell(i).row}, 0, 0);
    gaps.push_back(length(points, i, beside) / (steps.column_unit * steps.at[i]));
  }
  return raster.last_column() - raster.first_column() > 2 && finite_median(std::move(gaps)) <= 2;
}

// The four samples of a cell in a ring, some of them `none`: this one, the next in its column, the one
// across, the next in its row.
using Corners = std::array<Index, 4>;

// The halves of a cell whose edges are no depth jumps.
class Halves {
 public:
  Halves(Points points, const Steps& steps) : points_(points), steps_(steps) {}

  void put(const Corners& corners, std::vector<Triangle>& found) const {
    const double longest = std::max(1.0, steps_.column_unit);
    std::array<bool, 4> edge{};
    for (std::size_t k = 0; k < 4; ++k)
      edge[k] = joins(corners[k], corners[next_in(k, 4)], k % 2 == 0 ? 1 : steps_.column_unit);
    const bool rising = joins(corners[0], corners[2], longest),
               falling = joins(corners[1], corners[3], longest);
    const std::array<bool, 4> half{rising && edge[0] && edge[1], rising && edge[2] && edge[3],
                                   falling && edge[1] && edge[2], falling && edge[3] && edge[0]};
    const int of_rising = half[0] + half[1], of_falling = half[2] + half[3];
    const bool is_rising = of_rising != of_falling ? of_rising > of_falling
                                                   : length(points_, corners[0], corners[2]) <=
                                                         length(points_, corners[1], corners[3]);
    const auto [a, b, c, d] = corners;
    if (is_rising && half[0]) found.push_back({a, b, c});
    if (is_rising && half[1]) found.push_back({a, c, d});
    if (!is_rising && half[2]) found.push_back({b, c, d});
    if (!is_rising && half[3]) found.push_back({a, b, d});
  }

 private:
  bool joins(Index a, Index b, double unit) const {
    if (a == none || b == none) return false;
    return distance(points_[a], points_[b]) <=
           model::range_jump * unit * std::min(steps_.at[a], steps_.at[b]);
  }

  Points points_;
  const Steps& steps_;
};

}  // namespace

std::optional<RangeImage> image_of_raster(Points points, const Neighbours& neighbours,
                                          const std::vector<RasterCell>& cells, const Run& run) {
  if (cells.size() < model::range_fewest_points) return std::nullopt;
  Raster raster(cells);
  if (raster.has_two_in_a_cell()) return std::nullopt;
  const Steps steps = measure_steps(points, raster, run);
  if (!fits(points, neighbours, steps)) return std::nullopt;
  if (is_full_turn(points, raster, steps)) raster.close_turn();
  const Halves halves(points, steps);
  // A cell is that of its first sample or, where it has none, of the one above.
  auto triangles = parallel_gather<Triangle>(
      points.size(), Stage::Survey, run, [&](Index i, std::vector<Triangle>& found) {
        halves.put({i, raster.at(i, 0, 1), raster.at(i, 1, 1), raster.at(i, 1, 0)}, found);
        if (raster.at(i, 0, -1) == none)
          halves.put({none, i, raster.at(i, 1, 0), raster.at(i, 1, -1)}, found);
      });
  if (triangles.empty()) return std::nullopt;
  return RangeImage{{}, finite_median(steps.at), std::move(triangles)};
}

std::optional<RangeImage> find_range_image(Points points, const Neighbours& neighbours,
                                           const std::vector<RasterCell>& cells, const Run& run) {
  if (auto image = image_of_raster(points, neighbours, cells, run)) return image;
  return find_range_image(points, neighbours, run);
}

}  // namespace rimline
