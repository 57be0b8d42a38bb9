// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/balance.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace rimline {
namespace {

// Rates from each place of a row of `length` places to the next two on both sides: `right` times as much to
// the right as to the left.
RowMatrix line(Index length, double right) {
  RowMatrix a;
  for (Index i = 0; i < length; ++i) {
    for (const Index step : {-2, -1, 1, 2}) {
      if (i + step < 0 || i + step >= length) continue;
      a.columns.push_back(i + step);
      a.values.push_back(step > 0 ? -right : -1);
    }
    a.diagonal.push_back(1);
    a.offsets.push_back(static_cast<Index>(a.columns.size()));
  }
  return a;
}

// The ratio of one place's visits to those of the place to its left, far from the ends: the root other than 1
// of right (1 / x + 1 / x^2) + x + x^2 = 2 + 2 right, which says that what flows in is what leaves.
double growth(double right) {
  double low = 1 + 0.1 * (right - 1), high = 2;
  for (int i = 0; i < 100; ++i) {
    const double x = 0.5 * (low + high);
    (right * (1 / x + 1 / (x * x)) + x + x * x > 2 + 2 * right ? high : low) = x;
  }
  return low;
}

}  // namespace

TEST_CASE("mutual rates are in balance as they are") {
  for (const Index length : {5, 3000}) {
    for (const double v : balancing_rows(line(length, 1), {})) CHECK(v == doctest::Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("rates that are larger one way gather visits there, as in a geometric series") {
  const double ratio = growth(1.1);
  const std::vector<double> visits = balancing_rows(line(150, 1.1), {});
  for (Index i = 20; i < 130; ++i) CHECK(visits[i + 1] / visits[i] == doctest::Approx(ratio).epsilon(1e-6));
}

TEST_CASE("levels come towards the balance where one elimination does not do") {
  const std::vector<double> visits = balancing_rows(line(1000, 1.01), {});
  const double expected = 980 * std::log(growth(1.01));
  const double reached = std::log(visits[990] / visits[10]);  // 0 where nothing was balanced
  CHECK(reached > 0.3 * expected);
  CHECK(reached < 1.1 * expected);
  CHECK(std::accumulate(visits.begin(), visits.end(), 0.0) == doctest::Approx(1000));
}

TEST_CASE("a row that nobody lists and one that lists nobody keep a positive factor") {
  RowMatrix a = line(50, 1);
  a.diagonal.push_back(1);  // listed by nobody, lists row 3
  a.columns.push_back(3);
  a.values.push_back(-1);
  a.offsets.push_back(static_cast<Index>(a.columns.size()));
  a.diagonal.push_back(1);  // neither
  a.offsets.push_back(static_cast<Index>(a.columns.size()));
  const std::vector<double> visits = balancing_rows(a, {});
  for (const double v : visits) {
    CHECK(v > 0);
    CHECK(std::isfinite(v));
  }
}

}  // namespace rimline
