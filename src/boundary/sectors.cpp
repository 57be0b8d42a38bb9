// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/sectors.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/multiversioning.h"

namespace rimline {
namespace {

// The direction at `part` of `whole` of a turn. All directions are derived from the first eighth of the turn
// by symmetry, so that quarters lie on the axes and eighths on the diagonals exactly.
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

// The points at the origin, and those at half a turn or beyond it.
RIMLINE_WIDE void count_halves(const Lanes* u, const Lanes* v, std::size_t count, Lanes& at_origin,
                               Lanes& below) {
  for (int l = 0; l < lanes; ++l) {
    double origin = 0, half = 0;
    std::size_t j = 0;
    do {
      const double is_zero = u[j][l] == 0 ? 1 : 0, is_left = u[j][l] < 0 ? 1 : 0;
      const double is_half = v[j][l] == 0 ? is_left : 0;
      origin += v[j][l] == 0 ? is_zero : 0;
      half += v[j][l] < 0 ? 1 : is_half;
      ++j;
    } while (j < count);
    at_origin[l] = origin;
    below[l] = half;
  }
}

// The points whose angle is at least that of a direction above the first axis, and those whose angle is at
// least that of the opposite direction. Points at the origin are counted, although they must have no angle.
RIMLINE_WIDE void count_beyond(const Lanes* u, const Lanes* v, std::size_t count, UV direction, Lanes& beyond,
                               Lanes& beyond_opposite) {
  for (int l = 0; l < lanes; ++l) {
    double first = 0, second = 0;
    std::size_t j = 0;
    do {
      const double left = direction.u * v[j][l], right = direction.v * u[j][l];
      const double is_beyond = left >= right ? 1 : 0, is_beyond_opposite = left <= right ? 1 : 0;
      first += v[j][l] < 0 ? 1 : is_beyond;
      second += v[j][l] < 0 ? is_beyond_opposite : 0;
      ++j;
    } while (j < count);
    beyond[l] = first;
    beyond_opposite[l] = second;
  }
}

}  // namespace

Sectors::Sectors(int count) {
  const bool even = count % 2 == 0;
  for (int s = 1; 2 * s < count; ++s) lines_.push_back({direction(s, count), s, even ? s + count / 2 : 0});
  for (int s = count / 2 + 1; !even && s < count; ++s) {
    const UV d = direction(s, count);
    lines_.push_back({{-d.u, -d.v}, 0, s});
  }
}

void Sectors::count(std::span<const Lanes> u, std::span<const Lanes> v, std::span<Lanes> counts) const {
  // First the points in a sector or a later one; counts that belong to no sector are written to a slot that
  // is not read.
  Lanes at_origin, half, unasked;
  count_halves(u.data(), v.data(), u.size(), at_origin, half);
  for (double& all : counts[0].number) all = static_cast<double>(u.size());
  if (counts.size() % 2 == 0) counts[counts.size() / 2] = half;
  for (const auto& [direction, sector, opposite] : lines_) {
    count_beyond(u.data(), v.data(), u.size(), direction, sector ? counts[sector] : unasked,
                 opposite ? counts[opposite] : unasked);
    for (int l = 0; sector && l < lanes; ++l) counts[sector][l] -= at_origin[l];
  }
  for (std::size_t s = 1; s < counts.size(); ++s) {
    for (int l = 0; l < lanes; ++l) counts[s - 1][l] -= counts[s][l];
  }
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
