// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/off_surface.h"

#include <algorithm>

#include "base/model.h"
#include "base/model_clean.h"
#include "base/parallel.h"
#include "base/quantile.h"
#include "clean/surface_fit.h"
#include "local/neighbourhood.h"
#include "local/point_sample.h"

namespace rimline {
namespace {

constexpr std::size_t most_measured = 4096;  // [speed]

// The 90 % quantile of the deviations: noise, and relief that quadrics can not follow.
double usual_deviation(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                       const Run& run) {
  const std::vector<Index> chosen = choose_sample(points, most_measured, run.without_progress());
  std::vector<double> deviations(chosen.size());
  parallel_tasks(chosen.size(), Stage::Neighbours, run, [&](std::size_t i) {
    deviations[i] = fit_without(points, neighbours, chosen[i], scale[chosen[i]]).deviation;
  });
  run.check_cancel();
  return quantile(deviations, model::stray_usual_share);
}

// Whether the surface is complete without the point: it continues around its foot, without a gap.
bool is_whole(const SurfaceFit& fit) {
  const double near = fit.height > model::stray_high ? model::stray_redundant_high : model::stray_redundant;
  return fit.nearest < near && fit.gap < model::stray_gap;
}

// Whether the point is off a surface that its neighbours tell.
bool lies_off(Points points, const Neighbours& neighbours, double scale, double usual, Index i) {
  const SurfaceFit fit = fit_without(points, neighbours, i, scale);
  const double deviation = std::max(usual, fit.deviation);
  const double allowed = is_whole(fit)
                             ? std::max(model::stray_least_whole, model::stray_deviations_whole * deviation)
                             : std::max(model::stray_least, model::stray_deviations * deviation);
  return fit.height > allowed && fit.others <= model::stray_most_others;
}

}  // namespace

std::vector<char> lies_off_surface(Points points, const Neighbours& neighbours,
                                   const std::vector<double>& scale, const Run& run) {
  const double usual = usual_deviation(points, neighbours, scale, run);
  const double least = std::max(model::stray_least_whole, model::stray_deviations_whole * usual);
  std::vector<char> off(points.size());
  parallel_slices(points.size(), Stage::Neighbours, run, [&](std::size_t begin, std::size_t end) {
    Neighbourhoods neighbourhoods(std::min(model::more_neighbours, neighbours.k));
    PrincipalAxesLanes axes;
    Lanes height;
    for (auto first = static_cast<Index>(begin); first < static_cast<Index>(end); first += lanes) {
      neighbourhoods.gather(points, neighbours, first, static_cast<Index>(end));
      neighbourhoods.find_axes(axes);
      neighbourhoods.find_heights(axes, height);
      for (Index i = first; i < std::min(first + lanes, static_cast<Index>(end)); ++i) {
        if (height[i - first] >= model::stray_quick * least * scale[i])
          off[i] = lies_off(points, neighbours, scale[i], usual, i);
      }
    }
  });
  return off;
}

}  // namespace rimline
