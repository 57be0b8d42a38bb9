// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/smooth_curve/smooth_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/model.h"
#include "loops/smooth_curve/likeliest_path.h"
#include "loops/smooth_curve/projections.h"
#include "loops/smooth_curve/rim_curve.h"
#include "loops/smooth_curve/untangle.h"

namespace rimline {
namespace {

// A curve and the points near it, from the outermost inwards.
struct Layout {
  RimCurve curve;
  std::vector<Projection> projections;
};

std::optional<Layout> lay_out(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                              const std::vector<RimSample>& samples, double period, const NoiseModel& noise,
                              const Run& run) {
  const double window = model::curve_window + model::curve_window_noise * noise.noise;
  auto curve = fit_rim_curve(points, neighbours, spacing, samples, period, window, run);
  if (!curve) return {};
  std::vector<Projection> found = project(*curve, points, neighbours, samples, run);
  if (noise.anisotropic) {
    curve = curve->with_densities(offsets_behind(*curve, found, points, neighbours), run);
    for (Projection& p : found) p.out *= curve->knot(p.knot).out_density;
  }
  return Layout{*std::move(curve), from_outermost(std::move(found), run)};
}

// Median distance of the rim's own points from the curve.
double row_of(const std::vector<Projection>& projections) {
  std::vector<double> out;
  for (const Projection& p : projections) {
    if (p.is_sample) out.push_back(p.out);
  }
  return out.empty() ? 0 : out[out.size() / 2];  // the projections descend
}

// The number of points of the rim, by the density behind it; 0 where there is no area behind.
std::size_t expected_count(const Layout& layout) {
  // The density is measured in a strip behind the rim with soft edges, so that no row comes in or falls out
  // as a whole.
  constexpr double middle = model::strip_middle, width = model::strip_width;
  const auto& [curve, projections] = layout;
  const double row = row_of(projections);
  double behind = 0;
  for (const Projection& p : projections) behind += std::max(0.0, 1 - std::abs(p.out - row + middle) / width);
  const double density = behind / (width * curve.strip(middle - row));
  const double count = std::sqrt(density) * curve.point_count() * curve.strip(-row) / curve.strip(0);
  return count < 1e9 ? static_cast<std::size_t>(std::lround(count)) : 0;  // [guard]
}

// The count near the expected one for which fewest points lie at the line that separates the first so many
// points from the others.
std::size_t count_at_valley(const Layout& layout, std::size_t count, bool anisotropic) {
  constexpr double width = model::valley_width;
  const auto& [curve, found] = layout;
  const auto beyond = [&all = layout.projections](double out) {  // how many lie farther out
    const auto at = std::lower_bound(all.begin(), all.end(), out,
                                     [](const Projection& p, double x) { return p.out > x; });
    return static_cast<std::size_t>(at - all.begin());
  };
  const double usual = 2 * width * curve.strip(0);  // one point to a square spacing
  const double share = anisotropic ? model::valley_share_anisotropic : model::valley_share;
  const double likely = 1 + share * static_cast<double>(count);
  const auto most = static_cast<std::size_t>(std::lround(2 * likely));
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = count;
  for (std::size_t k = count - std::min(most, count - 1); k <= count + most && k < found.size(); ++k) {
    const double at = 0.5 * (found[k - 1].out + found[k].out);
    const auto crowd = static_cast<double>(beyond(at - width) - beyond(at + width));
    const double off = (static_cast<double>(k) - static_cast<double>(count)) / likely;
    const double cost = crowd / usual + 0.5 * off * off;
    if (cost < least) {
      least = cost;
      best = k;
    }
  }
  return best;
}

// The number of points so close behind a rim of `count` points that they can not be told from it: half a
// spacing of random points. Rows along the rim are not random.
std::size_t count_close_behind(std::size_t count, const NoiseModel& noise) {
  if (noise.anisotropic) return 0;
  return static_cast<std::size_t>(
      std::lround(model::random_close * noise.irregular * static_cast<double>(count)));
}

// The line between the first `last` projections, which may be on the rim, and the others. Among random points
// without noise, half of the first `count` lie farther out than the rim's own line, so half a spacing is
// measured from there: to count what lies in it is wrong by as much as chance has put there.
double parting_line(const std::vector<Projection>& projections, std::size_t count, std::size_t last,
                    const NoiseModel& noise) {
  if (last > count && noise.noise == 0 && noise.irregular >= model::is_random)
    return projections[count / 2].out - model::random_close;
  return 0.5 * (projections[last - 1].out + projections[last].out);
}

}  // namespace

SmoothedLoop smooth_loop(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                         const std::vector<Index>& rim, const std::vector<Point>& normals,
                         const NoiseModel& noise, const Run& run) {
  constexpr std::size_t shortest = model::curve_least;
  constexpr int rounds = model::curve_rounds;
  if (rim.size() < shortest) return {};
  std::vector<RimSample> samples;
  for (std::size_t i = 0; i < rim.size(); ++i)
    samples.push_back({static_cast<double>(i), rim[i], normals[i]});
  for (int round = 1;; ++round) {
    const auto layout =
        lay_out(points, neighbours, spacing, samples, static_cast<double>(rim.size()), noise, run);
    if (!layout) return {};
    const std::vector<Projection>& all = layout->projections;
    const std::size_t expected = expected_count(*layout);
    if (expected < shortest || expected >= all.size()) return {};
    const std::size_t close = count_close_behind(expected, noise);
    // Beyond so many points, the points behind a rim do not determine the rim.
    if (expected + close < rim.size()) return {};
    const std::size_t count = count_at_valley(*layout, expected, noise.anisotropic);
    const std::size_t last = std::min(all.size() - 1, count + close);
    if (round < rounds) {
      samples = along_curve(all, last);
      continue;
    }
    const bool is_even = noise.noise > 0 && noise.irregular < model::is_random && !noise.anisotropic;
    std::vector<RimSample> on_rim =
        is_even ? likeliest_path(layout->curve, all, count, noise.noise) : along_curve(all, count);
    if (on_rim.size() < shortest) return {};
    SmoothedLoop result;
    for (const RimSample& s : untangle(points, std::move(on_rim))) result.loop.push_back(s.point);
    const double line = parting_line(all, count, last, noise);
    for (const Projection& p : all) {
      result.near.push_back(p.point);
      result.depth.push_back(p.out - line);
    }
    return result;
  }
}

}  // namespace rimline
