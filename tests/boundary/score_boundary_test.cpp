// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/score_boundary.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "boundary/chi_square.h"
#include "boundary/sectors.h"
#include "boundary/simple.h"
#include "local/neighbourhood.h"
#include "shapes.h"

namespace rimline {
namespace {

BoundaryScores scores_of(Points points, int k = 40) {
  BoundaryOptions options;
  options.k = k;
  return score_boundary(points, find_neighbours(points, k, {}), options, {});
}

Neighbours all_others_of_first(Points points) {
  Neighbours others;
  others.k = static_cast<int>(points.size()) - 1;
  for (Index i = 1; i <= others.k; ++i) others.ids.push_back(i);
  return others;
}

PrincipalAxes axes_about_first(const std::vector<Point>& points) {
  const Neighbours others = all_others_of_first(points);
  Neighbourhoods neighbourhoods(others.k);
  PrincipalAxesLanes axes;
  neighbourhoods.gather(points, others, 0, 1);
  neighbourhoods.find_axes(axes);
  return axes.of(0);
}

// By the arithmetic of lanes, point by point: sums over even and odd neighbours, all else one after the
// other.
BoundaryScores scores_one_by_one(Points points, const Neighbours& neighbours,
                                 const BoundaryOptions& options) {
  BoundaryScores scores;
  const int k = neighbours.k;
  const Sectors sectors(options.sectors);
  for (Index i = 0; i < neighbours.size(); ++i) {
    Point sum[2];
    Covariance squares[2];
    std::vector<Point> offsets;
    for (const Index id : neighbours.of(i)) {
      const Point d = points[id] - points[i];
      const std::size_t odd = offsets.size() % 2;
      offsets.push_back(d);
      sum[odd] = sum[odd] + d;
      Covariance& s = squares[odd];
      s = {s.xx + d.x * d.x, s.xy + d.x * d.y, s.xz + d.x * d.z,
           s.yy + d.y * d.y, s.yz + d.y * d.z, s.zz + d.z * d.z};
    }
    const Point total = sum[0] + sum[1], mean = (1.0 / k) * total;
    const auto [a, b] = squares;
    PrincipalAxes axes = principal_axes({a.xx + b.xx - total.x * mean.x, a.xy + b.xy - total.x * mean.y,
                                         a.xz + b.xz - total.x * mean.z, a.yy + b.yy - total.y * mean.y,
                                         a.yz + b.yz - total.y * mean.z, a.zz + b.zz - total.z * mean.z});
    for (double& lambda : axes.lambda) lambda = std::max(0.0, lambda);
    const auto image_along = [&](int direction) {
      std::vector<double> image;
      double third[2] = {0, 0};
      for (const Point& d : offsets) {
        const double along = dot(d, axes.v[direction]);
        third[image.size() % 2] += along * along * along;
        image.push_back(along);
      }
      const double lambda = axes.lambda[direction];
      const double scale = lambda > 1e-13 * axes.lambda[2] ? 1 / std::sqrt(lambda) : 0;
      for (double& x : image) x *= third[0] + third[1] < 0 ? -scale : scale;
      return image;
    };
    const std::vector<double> u = image_along(2), v = image_along(1);
    std::vector<double> counted(options.sectors);
    for (int j = 0; j < k; ++j) {
      std::vector<Lanes> one_u(1), one_v(1), counts(options.sectors);
      one_u[0][3] = u[j], one_v[0][3] = v[j];
      sectors.count(one_u, one_v, counts);
      for (int s = 0; s < options.sectors; ++s) counted[s] += counts[s][3];
    }
    double squares_of_counts = 0;
    for (const double count : counted) squares_of_counts += count * count;
    scores.log_score.push_back(
        negative_log_survival(options.sectors * squares_of_counts / k - k, options.sectors - 1));
    scores.delta.push_back(static_cast<float>(delta(axes)));
  }
  return scores;
}

TEST_CASE("every rim point of an even disc is a candidate and its centre is not") {
  const auto disc = shapes::disc(14);
  const BoundaryScores scores = scores_of(disc.points);
  for (const Index id : disc.rim) CHECK(scores.candidate[id] == 1);
  CHECK(scores.candidate[0] == 0);
}

TEST_CASE("the axes of a flat cross are known: eigenvalues, directions, share") {
  const PrincipalAxes axes =
      axes_about_first({{1, 1, 5}, {1, 1, 5}, {4, 1, 5}, {-2, 1, 5}, {1, 2, 5}, {1, 0, 5}});
  CHECK(axes.lambda[0] == doctest::Approx(0));
  CHECK(axes.lambda[1] == doctest::Approx(2));
  CHECK(axes.lambda[2] == doctest::Approx(18));
  CHECK(std::abs(axes.v[0].z) == doctest::Approx(1));
  CHECK(std::abs(axes.v[2].x) == doctest::Approx(1));
  CHECK(delta(axes) == doctest::Approx(0.1));
}

TEST_CASE("sigma gives both principal directions equal variability") {
  const auto disc = shapes::disc(6, 0.1);
  std::vector<Point> stretched;
  for (const Point& p : disc.points) stretched.push_back({7 * p.x, p.y, p.z});
  const Neighbours others = all_others_of_first(stretched);
  Neighbourhoods neighbourhoods(others.k);
  PrincipalAxesLanes axes;
  neighbourhoods.gather(stretched, others, 0, 1);
  neighbourhoods.find_axes(axes);
  neighbourhoods.flatten(axes);
  for (const auto& image : {neighbourhoods.u(), neighbourhoods.v()}) {
    double mean = 0, squares = 0;
    for (const Lanes& x : image) mean += x[0] / static_cast<double>(image.size());
    for (const Lanes& x : image) squares += (x[0] - mean) * (x[0] - mean);
    CHECK(squares == doctest::Approx(1));
  }
}

TEST_CASE("the image is that of the general eigen-solver, for odd and even k and far from the origin") {
  auto points = shapes::turned(shapes::disc(12, 0.3).points, 0.4, 0.2, 1);
  for (Point& p : points) p = p + Point{30, -20, 10};
  for (const int k : {4, 7, 25, 40}) {
    const Neighbours neighbours = find_neighbours(points, k, {});
    Neighbourhoods neighbourhoods(k);
    PrincipalAxesLanes axes;
    std::vector<UV> image;
    std::size_t different = 0;
    const Index end = static_cast<Index>(points.size());
    for (Index i = 0; i < end; ++i) {
      const int lane = i % lanes;
      if (lane == 0) {
        neighbourhoods.gather(points, neighbours, i, end);
        neighbourhoods.find_axes(axes);
        neighbourhoods.flatten(axes);
      }
      simple::flatten(points, i, neighbours.of(i), simple::covariance(points, neighbours.of(i)), image);
      double worst = 0;
      for (int j = 0; j < k; ++j) {
        worst = std::max({worst, std::abs(neighbourhoods.u()[j][lane] - image[j].u),
                          std::abs(neighbourhoods.v()[j][lane] - image[j].v)});
      }
      different += worst > 1e-6;
    }
    // Where two eigenvalues or the two sides nearly agree, rounding decides the axes.
    CHECK(different <= points.size() / 100);
  }
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

TEST_CASE("scores are those of the test done the long way") {
  const auto disc = shapes::disc(14, 0.2);
  const auto points = shapes::turned(disc.points, 0.3, 0.5, 0.7);
  for (const auto& [k, sectors] : {std::pair(25, 5), std::pair(40, 8), std::pair(39, 7), std::pair(40, 2)}) {
    const Neighbours neighbours = find_neighbours(points, k, {});
    BoundaryOptions options;
    options.k = k;
    options.sectors = sectors;
    const BoundaryScores scores = score_boundary(points, neighbours, options, {});
    std::vector<UV> image;
    std::vector<int> counts;
    std::size_t different = 0;
    for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
      const simple::Covariance shape = simple::covariance(points, neighbours.of(i));
      simple::flatten(points, i, neighbours.of(i), shape, image);
      simple::count_sectors(image, sectors, counts);
      const double expected = negative_log_survival(pearson_statistic(counts), sectors - 1);
      different += std::abs(scores.log_score[i] - expected) > 1e-9 * (1 + expected);
      CHECK(scores.delta[i] == doctest::Approx(shape.delta()).epsilon(1e-6));
    }
    // The rings of the disc put some points on edges of sectors, where the last bit decides.
    CHECK(different <= points.size() / 100);
  }
}

TEST_CASE(
    "lanes change no byte: not on grids, whose points lie on edges of sectors, nor where some are left "
    "over") {
  std::vector<Point> grid;
  for (int i = 0; i < 1003; ++i) grid.push_back({0.5 * (i % 30), 0.25 * (i / 30), 0});
  auto bent = shapes::turned(grid, 0.3, 0.5, 0.7);
  for (Point& p : bent) p.z += 0.01 * p.x * p.x;
  for (const auto& points : {grid, bent, shapes::disc(14, 0.2).points}) {
    for (const auto& [k, sectors] : {std::pair(40, 8), std::pair(25, 5)}) {
      BoundaryOptions options;
      options.k = k;
      options.sectors = sectors;
      const Neighbours neighbours = find_neighbours(points, k, {});
      const BoundaryScores scores = score_boundary(points, neighbours, options, {});
      const BoundaryScores alone = scores_one_by_one(points, neighbours, options);
      CHECK(scores.log_score == alone.log_score);
      CHECK(scores.delta == alone.delta);
    }
  }
}

TEST_CASE("one and two threads give the same scores") {
  const auto disc = shapes::disc(40, 0.3);
  const Neighbours neighbours = find_neighbours(disc.points, 40, {});
  Run one, two;
  one.threads = 1;
  two.threads = 2;
  const BoundaryScores a = score_boundary(disc.points, neighbours, {}, one);
  const BoundaryScores b = score_boundary(disc.points, neighbours, {}, two);
  CHECK(a.log_score == b.log_score);
  CHECK(a.delta == b.delta);
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
  LoopOptions options;
  options.score_form = ScoreForm::Printed;
  CHECK(score(std::log(20.0), options) == doctest::Approx(20));
  CHECK(std::isfinite(score(1e6, options)));
  options.score_form = ScoreForm::Log;
  CHECK(score(3.5, options) == 3.5);
  CHECK(p_value(std::log(20.0)) == doctest::Approx(0.05));
}

TEST_CASE("the capped form is 1 / p down to its cap, and the same for all p below") {
  LoopOptions options;
  options.score_form = ScoreForm::Capped;
  options.score_cap = 1e-3;
  CHECK(score(std::log(20.0), options) == doctest::Approx(20));
  CHECK(score(std::log(999.0), options) == doctest::Approx(999));
  CHECK(score(std::log(1e9), options) == doctest::Approx(1000));
  CHECK(score(1e6, options) == doctest::Approx(1000));
  options.score_cap = 1e-6;
  CHECK(score(1e6, options) == doctest::Approx(1e6));
  for (const ScoreForm form : {ScoreForm::Printed, ScoreForm::Capped, ScoreForm::Log}) {
    options.score_form = form;
    CHECK(std::exp(log_of_score(7, options)) == doctest::Approx(score(7, options)));
  }
}

TEST_CASE(
    "a neighbour at the least distance there is does not lift the score above that of all in one sector") {
  // Seen from the first point all others are within one of 13 sectors but for one, beside it, whose image has
  // the smallest number that is not zero for a coordinate and is counted in that sector and in two more.
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<Point> points{{0, 0, 0}, {2 * tiny, 0, 0}};
  for (int i = 0; i < 39; ++i) {
    const double aside = i % 2 ? 0.114 : -0.114;
    points.push_back({2 * (0.71 + aside), 0.71 - aside, 0});
  }
  const Neighbours others = find_neighbours(points, 40, {});
  BoundaryOptions options;
  options.k = others.k;
  options.sectors = 13;
  const double most = negative_log_survival(13.0 * options.k - options.k, 12);
  CHECK(score_boundary(points, others, options, {}).log_score[0] == doctest::Approx(most));
}

}  // namespace
}  // namespace rimline
