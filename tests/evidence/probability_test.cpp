// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/probability.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace rimline;

namespace {

double logit(double p) { return std::log(p / (1 - p)); }

}  // namespace

TEST_CASE("the log odds of a rim are the linear form that the model writes down") {
  const model::RimModel m;
  CHECK(logit(loop_probability(12, 0.5, 0)) == doctest::Approx(m.constant + 0.5 * m.empty_ball));
  CHECK(logit(loop_probability(24, 0.5, 0.1)) ==
        doctest::Approx(m.constant + std::log(2.0) * m.size + 0.5 * m.empty_ball + 0.1 * m.thickness));
  CHECK(loop_probability(24, 1, 0.1) == loop_probability(1000, 1, 0.1));  // more points say no more
  CHECK(loop_probability(24, 3, 0.1) == loop_probability(24, 5, 0.1));    // nor do larger balls
}

TEST_CASE("a rim is likelier with more points, larger empty balls and flatter frames") {
  CHECK(loop_probability(8, 1, 0.1) < loop_probability(20, 1, 0.1));
  CHECK(loop_probability(20, 0.5, 0.1) < loop_probability(20, 1, 0.1));
  CHECK(loop_probability(20, 1, 0.3) < loop_probability(20, 1, 0.1));
}

TEST_CASE("the log odds of a false ear are a linear form of its measures") {
  const model::FalseEarModel& m = model::false_ear;
  CHECK(false_ear_log_odds({0, 0, 0}) == doctest::Approx(m.constant));
  CHECK(false_ear_log_odds({2, 3, 0.5}) ==
        doctest::Approx(m.constant + 2 * m.angle + 3 * m.log_tail + 0.5 * m.jaggedness));
}

TEST_CASE(
    "a point of a sure rim has the odds of its own evidence, that of an unlikely rim no more than twice the "
    "rim's") {
  const model::PointOnRimModel m;
  const double rim = logit(0.9), chi = std::log1p(5.0);
  CHECK(logit(point_probability(2, true, 5, 0.9)) ==
        doctest::Approx(m.constant + 2 * m.ear + chi * m.chi + rim * m.rim));
  CHECK(point_probability(100, true, 5, 0.9) == point_probability(m.most_ear, true, 5, 0.9));
  for (const double p : {0.01, 0.1, 0.4}) CHECK(point_probability(8, true, 1000, p) <= 2 * p);
  CHECK(point_probability(0, false, 5, 0.9) < point_probability(0, true, 5, 0.9));
}

TEST_CASE("a loop as wide as one disc is no gap, and less the narrower it is") {
  CHECK(no_gap(1) == 1);
  CHECK(no_gap(7) == 1);
  CHECK(no_gap(0.5) == doctest::Approx(0.25));
}

TEST_CASE("the frames about the end of a tube are as thick as the law of small openings says, twice over") {
  // A tube of n points around in square rows, by its own covariance.
  for (const int n : {8, 12, 20}) {
    const double radius = n / 6.283185307179586;
    std::vector<Point> points;
    for (int row = 0; row < 6; ++row) {
      for (int i = 0; i < n; ++i) {
        const double turn = 6.283185307179586 * i / n;
        points.push_back({radius * std::cos(turn), radius * std::sin(turn), double(row)});
      }
    }
    const auto frames = fit_frames(points, find_neighbours(points, 12, {}), {});
    double mean = 0;
    for (int i = 0; i < n; ++i) mean += frames[i].thickness / n;
    CHECK(2 * thickness_of_opening(n) == doctest::Approx(mean).epsilon(0.25));
  }
}

TEST_CASE("under noise a point on the parting line is as likely as not, and noise flattens what depth says") {
  CHECK(blurred_probability(0, 0.3, 0.99) == doctest::Approx(0.5));
  CHECK(blurred_probability(0.2, 0.1, 0.99) > blurred_probability(0.2, 0.5, 0.99));
  CHECK(blurred_probability(-0.2, 0.1, 0.99) < blurred_probability(-0.2, 0.5, 0.99));
}
