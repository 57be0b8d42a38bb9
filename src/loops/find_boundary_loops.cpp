// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "base/compaction.h"
#include "local/denoise.h"
#include "loops/classify.h"
#include "loops/rate_points.h"
#include "loops/smooth_curve/smooth_loops.h"
#include "loops/trace.h"
#include "rimline/boundary_loops.h"
#include "rimline/find_genetic_loop.h"
#include "search/false_ears.h"
#include "surface/measure_components.h"
#include "surface/propose.h"
#include "surface/scan_raster.h"

namespace rimline {

const char* name(PointLabel label) {
  constexpr std::array names{"interior", "boundary", "undersampled", "crease", "stray"};
  return names[static_cast<std::size_t>(label)];
}

namespace {

void check(Points points, const BoundaryLoopOptions& options) {
  if (points.size() < 4) {
    throw Error(ErrorCode::TooFewPoints,
                "loops need at least 4 points, there are " + std::to_string(points.size()));
  }
  if (options.min_loop < 3) throw Error(ErrorCode::BadOption, "min_loop must be at least 3");
  if (options.rim_population < 2) throw Error(ErrorCode::BadOption, "rim_population must be at least 2");
  if (options.rim_generations < 0) throw Error(ErrorCode::BadOption, "rim_generations must not be negative");
}

TriangleSet propose(const Samples& samples, const std::optional<RangeImage>& image, const Run& run) {
  if (image) return range_image_triangles(samples.points, samples.frames, *image);
  return propose_surface(samples, run);
}

std::vector<SurfaceComponent> with_loop_counts(std::vector<SurfaceComponent> components,
                                               const std::vector<Loop>& boundaries) {
  for (const Loop& loop : boundaries) ++components[loop.component].loops;
  return components;
}

std::vector<PointLabel> label_loops(std::vector<PointLabel> label, const std::vector<Loop>& boundaries,
                                    const std::vector<Loop>& gaps, const std::vector<Frame>& frames) {
  for (const Loop& gap : gaps) {
    for (const Index v : gap.points) {
      if (label[v] == PointLabel::Stray) continue;
      label[v] = is_folded(frames[v]) ? PointLabel::Crease : PointLabel::Undersampled;
    }
  }
  for (const Loop& loop : boundaries) {
    for (const Index v : loop.points) label[v] = PointLabel::Boundary;
  }
  return label;
}

std::vector<Loop> with_lengths(std::vector<Loop> loops, Points points) {
  for (Loop& loop : loops) loop.length = loop_length(points, loop.points);
  return loops;
}

}  // namespace

BoundaryLoops find_boundary_loops(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                                  const BoundaryLoopOptions& options, double length_exponent,
                                  const Run& run) {
  return find_boundary_loops(points, neighbours, local_spacing(points, neighbours, run), scores, options,
                             length_exponent, run);
}

BoundaryLoops find_boundary_loops(Points points, const Neighbours& neighbours, std::vector<double> spacing,
                                  const BoundaryScores& scores, const BoundaryLoopOptions& options,
                                  double length_exponent, const Run& run,
                                  const std::vector<RasterCell>& raster) {
  check(points, options);
  const auto image = find_range_image(points, neighbours, raster, run);
  const auto sampling = image ? of_range_image() : profile_sampling(points, neighbours, spacing, run);
  const auto denoised = denoise(points, neighbours, sampling, run);
  const auto samples = denoised ? with_frames(denoised->points, denoised->neighbours, denoised->spacing, run)
                                : with_frames(points, neighbours, spacing, run);
  auto proposed = propose(samples, image, run);
  run.progress(Stage::Loops, 0, points.size());

  auto surface = select(std::move(proposed), samples, sampling, options, run);
  const LocalSizes sizes(surface.set, samples.neighbours, run);
  const auto [selection, behind, corners] =
      remove_false_ears(surface, sizes, samples, sampling, options, run);
  const auto parts = find_components(surface.set, selection, run);
  const auto components = measure_components(surface.set, selection, parts, run);
  surface.set = turn_over(std::move(surface.set), parts.turned, run);

  const RimEvidence evidence{surface.set, selection, behind, samples, sampling};
  const auto rims = trace_loops(evidence, parts, run);
  const auto [boundaries, gaps] = classify_loops(rims, components, evidence, options);
  const auto doubtful = doubtful_gaps(gaps, components, options);
  const auto rated = rate_points(rims, evidence, sizes, corners, scores);
  const auto [loops, smoothed] = smooth_loops(boundaries, rated, evidence, run);
  const auto probability = sampling.is_range_image ? smoothed : raise_at_cuts(smoothed, loops, samples);
  const auto label =
      label_loops(label_stray_points(surface.set, parts, components, run), loops, gaps, samples.frames);

  return {with_lengths(with_fitness(loops, probability, length_exponent), points),
          doubtful,
          probability,
          label,
          with_loop_counts(components, boundaries),
          KeptItems(selection, Stage::Loops, run).of(surface.set.triangles()),
          surface.summary,
          is_closed(boundaries, doubtful, components, points.size()),
          sampling.is_range_image};
}

}  // namespace rimline
