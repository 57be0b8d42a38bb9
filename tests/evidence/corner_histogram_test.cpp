// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/corner_histogram.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/random.h"
#include "surface/proposed.h"

using namespace rimline;

namespace {

// A disc of points on a hexagonal grid, each moved by up to `off`.
std::vector<Point> disc(double off) {
  Random random(5);
  std::vector<Point> points;
  for (int i = -20; i <= 20; ++i) {
    for (int j = -24; j <= 24; ++j) {
      const Point p{i + 0.5 * (j & 1), j * std::sqrt(0.75), 0};
      if (norm(p) > 15) continue;
      points.push_back(p + Point{off * (2 * random.uniform() - 1), off * (2 * random.uniform() - 1), 0});
    }
  }
  return points;
}

// The surface through the points, and a jagged way along its rim.
struct Sheet : ProposedSurface {
  explicit Sheet(double off)
      : ProposedSurface(disc(off)),
        sizes(set, neighbours),
        selected(set.size(), 1),
        rims(walk_rims(set, selected)) {
    for (auto& rim : rims) cut_teeth(rim);
  }

  // Takes the point behind each edge into the rim.
  void cut_teeth(std::vector<Index>& rim) const {
    std::vector<Index> teeth;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Index a = rim[i], b = rim[(i + 1) % rim.size()];
      teeth.insert(teeth.end(), {a, set.apex(selected_triangle(set, selected, a, b), a, b)});
    }
    rim = std::move(teeth);
  }

  LocalSizes sizes;
  Selection selected;
  std::vector<std::vector<Index>> rims;
};

constexpr double right_angle = std::numbers::pi / 2;

}  // namespace

TEST_CASE("a right angle is rare where triangles are regular and usual where they are not") {
  Sheet even(0.01), uneven(0.3);
  const auto log_tail = [](Sheet& sheet) {
    return CornerHistogram(sheet.set, sheet.sizes, sheet.neighbours, sheet.rims, sheet.selected)
        .log_tail(right_angle, 0);
  };
  CHECK(log_tail(even) > 6);
  CHECK(log_tail(uneven) > 1);
  CHECK(log_tail(uneven) < 4);
}

TEST_CASE("log_tail is the share of the corners near the rim that a count finds") {
  Sheet sheet(0.3);
  const CornerHistogram usual(sheet.set, sheet.sizes, sheet.neighbours, sheet.rims, sheet.selected);
  std::set<Index> rim, near;
  for (const auto& loop : sheet.rims) rim.insert(loop.begin(), loop.end());
  for (const Index v : rim) {
    const auto around = sheet.neighbours.of(v);
    near.insert(around.begin(), around.end());
  }
  double like = 0, all = 0;  // both limits are the start of an interval
  for (const Triangle& t : sheet.set.triangles()) {
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return rim.count(v) > 0; })) continue;
    if (std::none_of(t.begin(), t.end(), [&](Index v) { return near.count(v) > 0; })) continue;
    for (int i = 0; i < 3; ++i) {
      const auto p = [&](int k) { return sheet.points[t[(i + k) % 3]]; };
      ++all;
      like += angle_at(p(2), p(0), p(1)) >= right_angle && sheet.sizes.log_ratio(t) >= 0;
    }
  }
  REQUIRE(like > 20);
  CHECK(usual.log_tail(right_angle, 0) == doctest::Approx(std::log((all + 1) / (like + 1))));
}

TEST_CASE("nothing is usual or rare behind a rim that is even") {
  Sheet sheet(0.3);
  const auto even = walk_rims(sheet.set, sheet.selected);
  CHECK(CornerHistogram(sheet.set, sheet.sizes, sheet.neighbours, even, sheet.selected)
            .log_tail(right_angle, 0) == 0);
  CHECK(CornerHistogram().log_tail(2, 1) == 0);
}

TEST_CASE("histograms of two parts add up to twice one of equal parts: the same tails") {
  const Sheet sheet(0.2);
  const CornerHistogram one(sheet.set, sheet.sizes, sheet.neighbours, sheet.rims, sheet.selected);
  CornerHistogram both = one;
  both += one;
  CornerHistogram none;
  none += one;
  bool any = false;
  for (const double angle : {0.5, 1.0, 1.5, 2.5}) {
    for (const double ratio : {-0.5, 0.0, 0.3}) {
      CHECK(none.log_tail(angle, ratio) == one.log_tail(angle, ratio));
      CHECK(both.log_tail(angle, ratio) >= one.log_tail(angle, ratio));
      any |= both.log_tail(angle, ratio) > one.log_tail(angle, ratio);
    }
  }
  CHECK(any);
}
