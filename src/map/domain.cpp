// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/domain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/domain_traits.h"
#include "base/vec.h"
#include "rimline/run.h"

namespace rimline {
namespace {

// Length along the loop up to each of its points; the last entry is the whole.
std::vector<double> lengths_along(Points points, const std::vector<Index>& loop) {
  std::vector<double> along(loop.size() + 1, 0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    along[i + 1] = along[i] + distance(points[loop[i]], points[loop[next_in(i, loop.size())]]);
  }
  return along;
}

// The turning of the loop at each point: pi less the angle between the points a window's length before and
// after.
std::vector<double> turns(Points points, const std::vector<Index>& loop, const std::vector<double>& along) {
  const std::size_t n = loop.size();
  const double window = along[n] / 20;
  std::vector<double> turn(n);
  std::size_t ahead = 0;  // counts on beyond n
  std::vector<std::size_t> after(n), before(n);
  const auto at = [&](std::size_t i) { return along[i % n] + static_cast<double>(i / n) * along[n]; };
  for (std::size_t i = 0; i < n; ++i) {
    ahead = std::max(ahead, i + 1);
    while (at(ahead) - at(i) < window && ahead < i + n - 1) ++ahead;
    after[i] = ahead % n;
  }
  std::size_t behind = 0;
  for (std::size_t i = n; i < 2 * n; ++i) {
    while (at(i) - at(behind + 1) >= window && behind + 1 < i - 1) ++behind;
    before[i - n] = behind % n;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point e = points[loop[i]] - points[loop[before[i]]], f = points[loop[after[i]]] - points[loop[i]];
    turn[i] = std::atan2(norm(cross(e, f)), dot(e, f));
  }
  return turn;
}

void place_on_circle(const std::vector<Index>& loop, const std::vector<double>& along, std::vector<UV>& uv) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double angle = 2 * std::numbers::pi * along[i] / along.back();
    uv[loop[i]] = {std::cos(angle), std::sin(angle)};
  }
}

std::array<std::size_t, 4> given_corners(const std::vector<Index>& loop, std::span<const Index, 4> ids) {
  std::array<std::size_t, 4> at{};
  for (int c = 0; c < 4; ++c) {
    const auto found = std::find(loop.begin(), loop.end(), ids[c]);
    if (found == loop.end()) throw Error(ErrorCode::BadOption, "a corner is not on the outer loop", {ids[c]});
    at[c] = static_cast<std::size_t>(found - loop.begin());
  }
  // Sorts along the loop from the first one on.
  for (std::size_t& position : at) position += position < at[0] ? loop.size() : 0;
  std::sort(at.begin(), at.end());
  if (std::adjacent_find(at.begin(), at.end()) != at.end()) {
    throw Error(ErrorCode::BadOption, "two corners are the same point");
  }
  return at;
}

}  // namespace

std::array<std::size_t, 4> find_corners(Points points, const std::vector<Index>& loop) {
  const std::vector<double> along = lengths_along(points, loop);
  const std::vector<double> turn = turns(points, loop, along);
  std::vector<std::size_t> order(loop.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return turn[a] > turn[b]; });
  std::array<std::size_t, 4> corners{};
  // Lowers the least distance where a tenth of the length leaves fewer than four corners.
  for (double apart = along.back() / 10;; apart /= 2) {
    std::size_t found = 0;
    for (const std::size_t i : order) {
      const auto far = [&](std::size_t j) {
        const double d = std::abs(along[i] - along[j]);
        return std::min(d, along.back() - d) >= apart && i != j;
      };
      if (found < 4 &&
          std::all_of(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(found), far)) {
        corners[found++] = i;
      }
    }
    if (found == 4) break;
    if (loop.size() < 4) throw Error(ErrorCode::BadOption, "a loop of three points has no four corners");
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

void place_outline(Points points, const std::vector<Index>& loop, Domain domain,
                   std::span<const Index, 4> corners, std::vector<UV>& uv) {
  const std::vector<double> along = lengths_along(points, loop);
  if (traits(domain).outline != Outline::Box) return place_on_circle(loop, along, uv);
  const std::array<std::size_t, 4> at =
      corners[0] == none ? find_corners(points, loop) : given_corners(loop, corners);
  const std::size_t n = loop.size();
  // Length along the loop, continued past its end.
  const auto run_to = [&](std::size_t i) { return along[i % n] + static_cast<double>(i / n) * along[n]; };
  const auto first_of = [&](int side) { return side < 4 ? at[side] : at[0] + n; };
  const auto length = [&](int side) { return run_to(first_of(side + 1)) - run_to(first_of(side)); };
  const double height = traits(domain).square ? 1 : (length(1) + length(3)) / (length(0) + length(2));
  const std::array<UV, 5> place{UV{0, 0}, {1, 0}, {1, height}, {0, height}, {0, 0}};
  constexpr double bulge = 1e-3;
  for (int side = 0; side < 4; ++side) {
    const UV a = place[side], d{place[side + 1].u - a.u, place[side + 1].v - a.v};
    for (std::size_t i = first_of(side); i < first_of(side + 1); ++i) {
      const double t = (run_to(i) - run_to(first_of(side))) / length(side), out = 4 * bulge * t * (1 - t);
      uv[loop[i % n]] = {a.u + t * d.u + out * d.v, a.v + t * d.v - out * d.u};
    }
  }
}

}  // namespace rimline
