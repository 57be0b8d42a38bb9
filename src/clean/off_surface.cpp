// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/off_surface.h"

#include <algorithm>

#include "base/model_clean.h"
#include "base/parallel.h"
#include "base/quantile.h"
#include "clean/surface_fit.h"
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
  return fit.nearest < model::stray_redundant && fit.gap < model::stray_gap;
}

}  // namespace

std::vector<char> lies_off_surface(Points points, const Neighbours& neighbours,
                                   const std::vector<double>& scale, const Run& run) {
  const double usual = usual_deviation(points, neighbours, scale, run);
  const double least = std::max(model::stray_least_whole, model::stray_deviations_whole * usual);
  std::vector<char> off(points.size());
  parallel_for_each(points.size(), Stage::Neighbours, run, [&](Index i) {
    if (height_over_plane(points, neighbours, i, scale[i]) < model::stray_quick * least) return;
    const SurfaceFit fit = fit_without(points, neighbours, i, scale[i]);
    const double deviation = std::max(usual, fit.deviation);
    const double allowed = is_whole(fit)
                               ? std::max(model::stray_least_whole, model::stray_deviations_whole * deviation)
                               : std::max(model::stray_least, model::stray_deviations * deviation);
    off[i] = fit.height > allowed && fit.others <= model::stray_most_others;
  });
  return off;
}

}  // namespace rimline
