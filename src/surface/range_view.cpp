// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/range_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/model.h"
#include "base/parallel.h"
#include "base/quantile.h"

namespace rimline {
namespace {

constexpr double thorough = 5000, quick = 500;  // samples [speed]

// Evaluates views from any direction on a subset of the samples.
class Look {
 public:
  // Takes the samples of which `strewn` is below a share.
  Look(const std::vector<SeenSample>& samples, double share) {
    std::vector<double> in_space;
    for (const SeenSample& sample : samples) {
      if (sample.strewn >= share) continue;
      per_sample_ = sample.steps.size();
      steps_.insert(steps_.end(), sample.steps.begin(), sample.steps.end());
      in_space.push_back(sample.nearest);
    }
    least_ = in_space.empty() ? 0 : 0.5 * quantile(in_space, 0.5);
  }

  bool is_empty() const { return steps_.empty(); }

  // The distance of each sample to its nearest neighbour in the view.
  std::vector<double> nearest(Point view) const {
    std::vector<double> result;
    for (std::size_t first = 0; first < steps_.size(); first += per_sample_) {
      double least = 1e300;
      for (std::size_t i = first; i < first + per_sample_; ++i) {
        const double along = dot(steps_[i], view);
        least = std::min(least, dot(steps_[i], steps_[i]) - along * along);
      }
      result.push_back(std::sqrt(std::max(0.0, least)));
    }
    return result;
  }

  // The relative spread of these distances, plus that of the gaps between rows: 0 for a raster. The steps
  // along rows alone do not determine the view across them.
  double spread(Point view) const {
    std::vector<double> all = nearest(view);
    if (quantile(all, 0.5) < least_) return 1e300;  // [layout] a spread
    constexpr double most = 4;  // of the gaps, which are measured only where steps are even
    const double along_rows = relative_spread(all);
    if (along_rows > model::range_nearly) return along_rows + most;
    std::vector<double> gaps = to_next_row(view);
    return along_rows + (gaps.empty() ? most : std::min(most, relative_spread(gaps)));
  }

  // The median of these distances, where nearly all are equal to it.
  std::optional<double> step(Point view) const {
    constexpr double tolerance = model::range_step_tolerance, least_share = model::range_step_share;
    std::vector<double> all = nearest(view);
    const double middle = quantile(all, 0.5);
    const auto agree = std::count_if(all.begin(), all.end(),
                                     [&](double d) { return std::abs(d - middle) <= tolerance * middle; });
    const bool even = static_cast<double>(agree) >= least_share * static_cast<double>(all.size());
    return middle >= least_ && even ? std::optional(middle) : std::nullopt;
  }

 private:
  static double relative_spread(std::vector<double>& values) {
    return (quantile(values, 0.9) - quantile(values, 0.1)) / quantile(values, 0.5);  // [layout]
  }

  // The distance in the view from the line through a sample and its nearest neighbour to the next row: the
  // least over its other neighbours that are not nearly on the line.
  std::vector<double> to_next_row(Point view) const {
    constexpr double in_line = model::range_in_line * model::range_in_line;
    std::vector<double> result;
    std::vector<Point> seen(per_sample_);
    for (std::size_t first = 0; first < steps_.size(); first += per_sample_) {
      for (std::size_t i = 0; i < per_sample_; ++i)
        seen[i] = steps_[first + i] - dot(steps_[first + i], view) * view;
      const Point row = *std::ranges::min_element(seen, {}, [](Point p) { return dot(p, p); });
      double least = 1e300;
      for (const Point p : seen) {
        const Point off = cross(row, p);
        const double squared = dot(off, off);
        if (squared > in_line * dot(row, row) * dot(p, p)) least = std::min(least, squared / dot(row, row));
      }
      if (least < 1e300) result.push_back(std::sqrt(least));
    }
    return result;
  }

  std::vector<Point> steps_;
  std::size_t per_sample_ = 1;
  double least_ = 0;  // along a row the samples hide each other
};

struct View {
  double spread;
  Point direction;
};

// Directions distributed evenly over half the sphere (a Fibonacci lattice), sorted by spread.
std::vector<View> look_around(const Look& look, const Run& run) {
  constexpr int directions = 400;  // [speed]
  std::vector<View> views(directions);
  parallel_tasks(views.size(), Stage::Survey, run, [&](std::size_t i) {
    const double at = static_cast<double>(i) + 0.5, z = at / directions, r = std::sqrt(1 - z * z);
    const double angle = std::numbers::pi * (1 + std::sqrt(5.0)) * at;  // [layout] golden angle
    const Point direction{r * std::cos(angle), r * std::sin(angle), z};
    views[i] = {look.spread(direction), direction};
  });
  std::stable_sort(views.begin(), views.end(),
                   [](const View& a, const View& b) { return a.spread < b.spread; });
  return views;
}

// Descends to the least spread near a view, with decreasing steps.
View settle(const Look& look, View view) {
  double stride = 0.1;                             // radians [speed]
  for (int step = 0; step < 200 && stride > 1e-4;  // [guard]
       ++step) {                                   // bounded, because rounding could cause a cycle [guard]
    const auto [u, v] = axes_across(view.direction);
    bool better = false;
    for (int k = 0; k < 8 && !better; ++k) {  // [speed]
      const double angle = k * std::numbers::pi / 4;
      const Point to = view.direction + stride * (std::cos(angle) * u + std::sin(angle) * v);
      const Point unit = (1 / norm(to)) * to;
      const double spread = look.spread(unit);
      better = spread < view.spread;
      if (better) view = {spread, unit};
    }
    if (!better) stride /= 2;
  }
  return view;
}

std::optional<RangeView> view_along(const Look& look, Point direction) {
  const std::optional<double> step = look.step(direction);
  return step ? std::optional(RangeView{direction, *step}) : std::nullopt;
}

}  // namespace

std::array<Point, 2> axes_across(Point direction) {
  const Point axis =
      std::abs(direction.x) < 0.8 ? Point{1, 0, 0} : Point{0, 1, 0};  // [guard] any axis not along it
  const Point u = cross(direction, axis), unit = (1 / norm(u)) * u;
  return {unit, cross(direction, unit)};
}

ViewSample& ViewSample::operator+=(const ViewSample& other) {
  count = std::max(count, other.count);
  seen.insert(seen.end(), other.seen.begin(), other.seen.end());
  return *this;
}

ViewSample sample_views(Points points, std::span<const Index> part, const Neighbours& neighbours,
                        const OwnFrame& own, const Run& run) {
  const int k = std::min(model::few_neighbours, neighbours.k);
  const double share = thorough / own.count;
  ViewSample sample{own.count, {}};
  sample.seen = parallel_gather<SeenSample>(part.size(), Stage::Survey, run,
                                            [&](Index at, std::vector<SeenSample>& found) {
                                              const Index i = part[at];
                                              const double place = strewn(own, points[i]);
                                              if (share < 1 && place >= share) return;
                                              SeenSample& seen = found.emplace_back();
                                              for (const Index j : neighbours.of(i, k))
                                                seen.steps.push_back(own.in(points[j] - points[i]));
                                              seen.nearest = distance_to(points, neighbours, i, 0);
                                              seen.strewn = place;
                                            });
  return sample;
}

std::optional<RangeView> view_from_front(const ViewSample& sample) {
  const Look all(sample.seen, 1);
  if (all.is_empty()) return std::nullopt;
  return view_along(all, {0, 0, 1});
}

std::optional<RangeView> best_view(const ViewSample& sample, const Run& run) {
  constexpr int starts = 4;  // [speed]
  const Look all(sample.seen, 1);
  const Look few(sample.seen, quick / sample.count);
  if (few.is_empty()) return std::nullopt;
  const std::vector<View> views = look_around(few, run);
  View best = views[0];
  for (int i = 0; i < starts; ++i) {
    const View view = settle(few, views[i]);
    if (view.spread < best.spread) best = view;
  }
  if (best.spread < model::range_nearly) best = settle(all, {all.spread(best.direction), best.direction});
  return view_along(all, best.direction);
}

}  // namespace rimline
