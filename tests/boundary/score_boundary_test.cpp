// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "boundary/chi_square.h"
#include "boundary/neighbourhood.h"
#include "boundary/sectors.h"
#include "rimline/boundary.h"
#include "shapes.h"

namespace rimline {
namespace {

BoundaryScores scores_of(Points points, int k = 40) {
  BoundaryOptions options;
  options.k = k;
  return score_boundary(points, find_neighbours(points, k, {}), options, {});
}

TEST_CASE("every rim point of an even disc is a candidate and its centre is not") {
  const auto disc = shapes::disc(14);
  const BoundaryScores scores = scores_of(disc.points);
  for (const Index id : disc.rim) CHECK(scores.candidate[id] == 1);
  CHECK(scores.candidate[0] == 0);
}

TEST_CASE("the covariance of a flat cross is known: eigenvalues, axes, centre") {
  const std::vector<Point> cross{{1, 1, 5}, {4, 1, 5}, {-2, 1, 5}, {1, 2, 5}, {1, 0, 5}};
  const std::vector<Index> ids{0, 1, 2, 3, 4};
  const Covariance c = covariance(cross, ids);
  CHECK(c.lambda1 == doctest::Approx(0));
  CHECK(c.lambda2 == doctest::Approx(2));
  CHECK(c.lambda3 == doctest::Approx(18));
  CHECK(std::abs(c.v1.z) == doctest::Approx(1));
  CHECK(std::abs(c.v3.x) == doctest::Approx(1));
  CHECK(c.delta() == doctest::Approx(0.1));
  CHECK(distance(c.centroid, {1, 1, 5}) < 1e-12);
}

TEST_CASE("sigma gives both principal directions equal variability") {
  const auto disc = shapes::disc(6, 0.1);
  std::vector<Point> stretched;
  for (const Point& p : disc.points) stretched.push_back({7 * p.x, p.y, p.z});
  std::vector<Index> ids;
  for (Index i = 1; i < static_cast<Index>(stretched.size()); ++i) ids.push_back(i);
  std::vector<UV> image;
  flatten(stretched, 0, ids, covariance(stretched, ids), image);
  double mean_u = 0, mean_v = 0, uu = 0, vv = 0;
  for (const UV& p : image) mean_u += p.u / image.size(), mean_v += p.v / image.size();
  for (const UV& p : image) {
    uu += (p.u - mean_u) * (p.u - mean_u);
    vv += (p.v - mean_v) * (p.v - mean_v);
  }
  CHECK(uu == doctest::Approx(1));
  CHECK(vv == doctest::Approx(1));
}

TEST_CASE("turning, scaling and moving the points changes no score") {
  const auto disc = shapes::disc(12, 0.3);
  const BoundaryScores scores = scores_of(disc.points);
  auto moved = shapes::turned(disc.points, 0.3, 1.1, -0.7);
  for (Point& p : moved) p = 13.0 * p + Point{100, -50, 7};
  const BoundaryScores again = scores_of(moved);
  std::size_t different = 0;
  for (std::size_t i = 0; i < moved.size(); ++i)
    different += std::abs(scores.log_score[i] - again.log_score[i]) > 1e-9;
  // A point may lie on the edge of a sector, where the last bit decides.
  CHECK(different <= moved.size() / 200);
  CHECK(scores.candidate.size() == moved.size());
}

TEST_CASE("mirroring the points changes no score") {
  const auto disc = shapes::disc(12, 0.3);
  std::vector<Point> mirrored;
  for (const Point& p : disc.points) mirrored.push_back({-p.x, p.y, p.z});
  const BoundaryScores scores = scores_of(disc.points), again = scores_of(mirrored);
  std::size_t different = 0;
  for (std::size_t i = 0; i < mirrored.size(); ++i) {
    different += std::abs(scores.log_score[i] - again.log_score[i]) > 1e-9;
  }
  CHECK(different <= mirrored.size() / 200);
}

TEST_CASE("the table of p-values agrees with the statistic computed the long way") {
  const auto disc = shapes::disc(9, 0.2);
  const int k = 25;
  const Neighbours neighbours = find_neighbours(disc.points, k, {});
  const BoundaryScores scores = scores_of(disc.points, k);
  std::vector<UV> image;
  std::vector<int> counts;
  for (Index i = 0; i < static_cast<Index>(disc.points.size()); ++i) {
    flatten(disc.points, i, neighbours.of(i), covariance(disc.points, neighbours.of(i)), image);
    count_sectors(image, 8, counts);
    const double statistic = pearson_statistic(counts);
    CHECK(scores.log_score[i] == doctest::Approx(negative_log_survival(statistic, 7)).epsilon(1e-9));
  }
}

TEST_CASE("points on a line are all candidates and nothing divides by zero") {
  std::vector<Point> line;
  for (int i = 0; i < 60; ++i) line.push_back({1.0 * i * i, 2.0 * i * i, 0});
  const BoundaryScores scores = scores_of(line);
  for (const double s : scores.log_score) CHECK(std::isfinite(s));
  for (const auto c : scores.candidate) CHECK(c == 1);
  for (const float d : scores.delta) CHECK(d < 1e-6f);
}

TEST_CASE("eq. (2) as printed is 1 / p and never overflows; its log form is -log p") {
  CHECK(score(std::log(20.0), ScoreForm::Printed) == doctest::Approx(20));
  CHECK(score(3.5, ScoreForm::Log) == 3.5);
  CHECK(std::isfinite(score(1e6, ScoreForm::Printed)));
  CHECK(p_value(std::log(20.0)) == doctest::Approx(0.05));
}

}  // namespace
}  // namespace rimline
