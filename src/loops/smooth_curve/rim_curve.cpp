// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/smooth_curve/rim_curve.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/model.h"
#include "base/parallel.h"
#include "base/vec.h"

namespace rimline {
namespace {

constexpr std::size_t knots_in_task = 32;  // long enough to hide the cost of a task [speed]

// The mean of the spacings around a point, which is less biased than its own: the neighbours of a rim point
// are on one side.
double spacing_about(const Neighbours& neighbours, const std::vector<double>& spacing, Index point) {
  const auto near = neighbours.of(point, std::min(model::few_neighbours, neighbours.k));
  double sum = 0;
  for (const Index v : near) sum += spacing[v];
  return sum / static_cast<double>(near.size());
}

// The quadratic about one t.
class LocalFit {
 public:
  LocalFit(Points points, const std::vector<RimSample>& samples, const std::vector<double>& spacing,
           double period, double window)
      : points_(points), samples_(samples), spacing_(spacing), period_(period), window_(window) {}

  std::optional<Knot> at(double t) const {
    Sums sums;
    const auto n = static_cast<std::ptrdiff_t>(samples_.size());
    const auto around = [&](std::ptrdiff_t k) {
      return static_cast<std::size_t>(k < 0 ? k + n : k < n ? k : k - n);
    };
    const auto first = std::lower_bound(samples_.begin(), samples_.end(), t,
                                        [](const RimSample& s, double value) { return s.t < value; }) -
                       samples_.begin();
    for (std::ptrdiff_t k = first; k < first + n && add(around(k), t, sums);) ++k;
    for (std::ptrdiff_t k = first - 1; k > first - n && add(around(k), t, sums);) --k;
    if (sums.count < 4) return {};
    const Eigen::Matrix3d fit = sums.squares.ldlt().solve(sums.right);
    const Point along{fit(1, 0), fit(1, 1), fit(1, 2)};
    Knot knot;
    knot.at = points_[samples_.front().point] + Point{fit(0, 0), fit(0, 1), fit(0, 2)};
    knot.step = std::max(norm(along), 1e-300);
    knot.along = unit(along);
    knot.normal = unit(sums.normal);
    knot.out = unit(cross(along, sums.normal));
    knot.spacing = sums.spacing / sums.weight;
    return knot;
  }

 private:
  struct Sums {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
    Point normal;
    double spacing = 0, weight = 0;
    int count = 0;
  };

  // False where the sample is out of the window.
  bool add(std::size_t i, double t, Sums& sums) const {
    const RimSample& sample = samples_[i];
    const double dt = std::remainder(sample.t - t, period_), far = std::abs(dt) / window_;
    if (far >= 1) return false;
    const double weight = std::pow(1 - far * far * far, 3);  // tricube
    const Eigen::Vector3d row(1, dt, dt * dt);
    const Point p = points_[sample.point] - points_[samples_.front().point];
    sums.squares += weight * row * row.transpose();
    sums.right += weight * row * Eigen::RowVector3d(p.x, p.y, p.z);
    sums.normal = sums.normal + weight * sample.normal;
    sums.spacing += weight * spacing_[i];
    sums.weight += weight;
    ++sums.count;
    return true;
  }

  Points points_;
  const std::vector<RimSample>& samples_;
  const std::vector<double>& spacing_;  // about each of the samples
  double period_, window_;
};

}  // namespace

std::optional<RimCurve> fit_rim_curve(Points points, const Neighbours& neighbours,
                                      const std::vector<double>& spacing,
                                      const std::vector<RimSample>& samples, double period, double window,
                                      const Run& run) {
  std::vector<double> about;
  for (const RimSample& sample : samples) about.push_back(spacing_about(neighbours, spacing, sample.point));
  const LocalFit fit(points, samples, about, period, std::min(window, period / 4));
  std::vector<Knot> knots(static_cast<std::size_t>(std::lround(2 * period)));
  const auto count = static_cast<double>(knots.size());
  std::atomic<bool> enough = true;
  parallel_slices(
      knots.size(), Stage::Loops, run,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          const auto knot = fit.at(period * static_cast<double>(i) / count);
          if (knot) {
            knots[i] = *knot;
          } else {
            enough = false;
          }
        }
      },
      knots_in_task);
  if (!enough) return {};
  return RimCurve(period, std::move(knots));
}

std::vector<double> RimCurve::running_count() const {
  std::vector<double> running{0};
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const Knot &a = knots_[i], &b = knots_[next_in(i, knots_.size())];
    running.push_back(running.back() +
                      a.along_density * distance(a.at, b.at) / (0.5 * (a.spacing + b.spacing)));
  }
  return running;
}

double RimCurve::strip(double depth) const {
  double sum = 0;
  const auto moved = [&](const Knot& k) { return k.at - depth * k.spacing * k.out; };
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const Knot &a = knots_[i], &b = knots_[next_in(i, knots_.size())];
    sum += distance(moved(a), moved(b)) / (0.5 * (a.spacing + b.spacing)) / a.out_density;
  }
  return sum;
}

RimCurve RimCurve::with_densities(const std::vector<std::pair<double, Offset>>& offsets,
                                  const Run& run) const {
  constexpr double window = model::curve_anisotropy_window;
  constexpr std::size_t stride = 6;  // from one measure to the next; between them it changes little [speed]
  const auto take = [&](double from, double to, std::vector<Offset>& near) {
    auto at = std::lower_bound(offsets.begin(), offsets.end(), from,
                               [](const auto& x, double t) { return x.first < t; });
    for (; at != offsets.end() && at->first < to; ++at) near.push_back(at->second);
  };
  const double reach = std::min(window, period_ / 2);
  std::vector<Anisotropy> measured((knots_.size() - 1) / stride + 1);
  parallel_tasks(measured.size(), Stage::Loops, run, [&](std::size_t m) {
    std::vector<Offset> near;
    for (const double turn : {-period_, 0.0, period_})
      take(t_of(m * stride) + turn - reach, t_of(m * stride) + turn + reach, near);
    measured[m] = find_anisotropy(near);
  });
  std::vector<Knot> knots = knots_;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots[i].along_density = std::sqrt(measured[i / stride].xx);
    knots[i].out_density = std::sqrt(measured[i / stride].yy);
  }
  return RimCurve(period_, std::move(knots));
}

}  // namespace rimline
