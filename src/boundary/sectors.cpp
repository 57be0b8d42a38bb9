// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/sectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace rimline {
namespace {

// Grows from 0 to 4 as the angle grows from 0 to a full turn: 1, 2, 3 at the quarters, and on a square rather
// than a circle in between. Quadrants are looked up: their order is random, and would mislead a branch.
double stand_in(double u, double v) {
  constexpr double base[] = {0, 4, 2, 2}, sign[] = {1, 1, -1, -1};
  const int quadrant = 2 * (u < 0) + (v < 0);
  const double size = std::max(std::abs(u) + std::abs(v), std::numeric_limits<double>::denorm_min());
  return base[quadrant] + sign[quadrant] * (v / size);
}

// The direction at `part` of `whole` of a turn. By symmetry all comes from the first eighth of the turn, so
// that quarters lie on the axes and eighths on the diagonals exactly.
UV direction(int part, int whole) {
  const int quarter = 4 * part / whole, rest = 4 * part % whole;  // rest / whole of a quarter is left
  const bool far = 2 * rest > whole;
  const double angle = 0.5 * std::numbers::pi * (far ? whole - rest : rest) / whole;
  UV d{std::cos(angle), std::sin(angle)};
  if (2 * rest == whole) d.u = d.v = std::numbers::sqrt2 / 2;
  if (far) std::swap(d.u, d.v);
  for (int i = 0; i < quarter; ++i) d = {-d.v, d.u};
  return d;
}

}  // namespace

Sectors::Sectors(int count) : cells_(8 * static_cast<std::size_t>(count)) {
  const double cells_in_quarter = 2.0 * count;
  constexpr double rounding = 1e-12;  // an edge this near to a cell's end is in the next one too
  const auto cell_at = [&](double where) {
    return std::min(static_cast<std::size_t>(where * cells_in_quarter), cells_.size() - 1);
  };
  std::size_t done = 0;
  for (int sector = 1; sector < count; ++sector) {
    const UV edge = direction(sector, count);
    const double where = stand_in(edge.u, edge.v);
    const std::size_t first = cell_at(where - rounding), last = cell_at(where + rounding);
    for (; done < first; ++done) cells_[done] = {{sector - 1, sector - 1}, {}};
    for (; done <= last; ++done) cells_[done] = {{sector - 1, sector}, edge};
  }
  for (; done < cells_.size(); ++done) cells_[done] = {{count - 1, count - 1}, {}};
}

int Sectors::of(double u, double v) const {
  const double last = static_cast<double>(cells_.size() - 1);
  const double at = stand_in(u, v) * (0.25 * static_cast<double>(cells_.size()));
  // The stand-in of a tiny negative angle rounds to a full turn; what is no number is put there too.
  const Cell& cell = cells_[static_cast<std::size_t>(at < last ? at : last)];
  return cell.sector[cell.edge.u * v >= cell.edge.v * u];
}

void Sectors::count(std::span<const double> u, std::span<const double> v, std::span<int> counts) const {
  std::fill(counts.begin(), counts.end(), 0);
  for (std::size_t i = 0; i < u.size(); ++i) ++counts[of(u[i], v[i])];
}

double pearson_statistic(std::span<const int> counts) {
  double total = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  double statistic = 0;
  for (const int count : counts) statistic += (count - expected) * (count - expected) / expected;
  return statistic;
}

}  // namespace rimline
