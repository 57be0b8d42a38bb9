// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/sample.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "base/random.h"
#include "sample/draft.h"
#include "sample/noise.h"
#include "sample/rim.h"

namespace rimline {
namespace {

constexpr std::size_t fewest = 50,
                      most = 1'000'000'000;  // ids are 32 bits; a crop samples more than it keeps

[[noreturn]] void refuse(const SampleOptions& options, const std::string& why) {
  throw Error(ErrorCode::BadOption,
              std::string(name(options.shape)) + ", " + name(options.sampling) + ": " + why);
}

void check(const SampleOptions& options) {
  if (options.n < fewest || options.n > most) {
    refuse(options, "n is " + std::to_string(options.n) + ", it must be from " + std::to_string(fewest) +
                        " to " + std::to_string(most));
  }
  if (!(options.noise >= 0 && std::isfinite(options.noise)))
    refuse(options, "noise must be a number from 0 up");
  if (options.sampling == Sampling::Cropped && options.shape == Shape::ClosedSphere) {
    refuse(options, "a closed surface has no boundary to crop at; crop sphere-minus-cap");
  }
}

DensityChange density_change(Sampling sampling) {
  if (sampling == Sampling::SmoothDensity) return DensityChange::Smooth;
  return sampling == Sampling::DensityStep ? DensityChange::Step : DensityChange::None;
}

// The spacing that gives about n points: n = area / spacing^2 + 0.5 rim / spacing, areas and lengths weighted
// by density. Half of the rim's own share of area lies outside the surface, hence the second term.
double spacing_for(const SampleOptions& options, const AnalyticSurface& surface) {
  const Density unit{density_change(options.sampling), 1};
  const double area = measure(surface, unit).weighted_area, n = static_cast<double>(options.n);
  if (options.sampling == Sampling::Cropped || options.sampling == Sampling::Random)
    return std::sqrt(area / n);
  double rim = 0;
  const StepLength length = [&](UV a, UV b) {
    return distance(surface.at(a), surface.at(b)) /
           unit.spacing_at(surface, {(a.u + b.u) / 2, (a.v + b.v) / 2});
  };
  constexpr double fine = 0.01;  // the rims' length in steps of a hundredth
  for (const auto& walked : walk_rims(surface, length, fine))
    rim += fine * static_cast<double>(walked.size());
  const double b = rim / 2;
  return 2 * area / (std::sqrt(b * b + 4 * area * n) - b);
}

Draft draw(const SampleOptions& options, const AnalyticSurface& surface, double spacing, const Run& run) {
  switch (options.sampling) {
    case Sampling::BlueNoise:
    case Sampling::SmoothDensity:
    case Sampling::DensityStep:
      return blue_noise(surface, {density_change(options.sampling), spacing}, run, options.n).draft;
    case Sampling::Random: return random_points(surface, spacing, options.n, run);
    case Sampling::Grid: return lattice(surface, spacing, 1, run, options.n);
    case Sampling::ScanLines: return lattice(surface, spacing, 4, run, options.n);
    case Sampling::Cropped: return cropped(options.shape, spacing, run, options.n);
  }
  refuse(options, "there is no such sampling");
}

// Whether the draft has the loops of the surface: a coarse crop may tear the patch or lose a hole.
bool is_whole(const Draft& draft, const AnalyticSurface& surface) {
  return draft.loops.size() == surface.rims.size();
}

// A crop that comes out whole, from the next seeds where need be.
Draft draw_whole(const SampleOptions& options, const AnalyticSurface& surface, double spacing, Run run) {
  constexpr int tries = 12;
  for (int i = 0; i < tries; ++i) {
    Draft draft = draw(options, surface, spacing, run);
    if (is_whole(draft, surface)) return draft;
    run.seed += 0x9e3779b97f4a7c15;
  }
  refuse(options, "n = " + std::to_string(options.n) + " is too small for the loops of the shape");
}

// The rims' corners, a crop's ragged edge and whole rows make the count differ from the estimate by a few
// points: drawn again with a corrected spacing where that matters.
Draft draw_about_n(const SampleOptions& options, const AnalyticSurface& surface, const Run& run) {
  constexpr double tolerance = 0.03;
  constexpr int tries = 4;
  const double n = static_cast<double>(options.n);
  const auto off = [n](const Draft& draft) { return std::abs(static_cast<double>(draft.points.size()) - n); };
  double spacing = spacing_for(options, surface);
  Draft best = draw_whole(options, surface, spacing, run);
  double last = static_cast<double>(best.points.size());
  for (int i = 1; i < tries && off(best) > tolerance * n; ++i) {
    spacing *= std::sqrt(last / n);
    Draft draft = draw_whole(options, surface, spacing, run);
    last = static_cast<double>(draft.points.size());
    if (off(draft) < off(best)) best = std::move(draft);
  }
  return best;
}

void check_rims(const SampleOptions& options, const Draft& draft) {
  constexpr std::size_t shortest = 5;
  for (const auto& loop : draft.loops) {
    if (loop.size() >= shortest) continue;
    refuse(options, "n = " + std::to_string(options.n) + " is too small: a loop would have " +
                        std::to_string(loop.size()) + " points");
  }
}

double closed_length(const std::vector<Point>& points, const std::vector<Index>& loop) {
  double length = distance(points[loop.back()], points[loop.front()]);
  for (std::size_t i = 1; i < loop.size(); ++i) length += distance(points[loop[i - 1]], points[loop[i]]);
  return length;
}

// Shuffles the points and numbers everything anew.
Sample finish(Draft draft, const SampleOptions& options, const Run& run) {
  Sample sample;
  for (const auto& loop : draft.loops) {
    const LoopKind kind = sample.loops.empty() ? LoopKind::Outer : LoopKind::Hole;
    sample.loops.push_back({loop, kind, closed_length(draft.points, loop), 0});
  }
  add_noise(draft.points, options.noise, run);

  std::vector<Index> place(draft.points.size());  // where a point of the draft goes
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<Index>(i);
  Random(run.seed, 4).shuffle(place);

  sample.points.resize(place.size());
  sample.boundary.assign(place.size(), 0);
  sample.near_boundary.assign(place.size(), 0);
  for (std::size_t i = 0; i < place.size(); ++i) sample.points[place[i]] = draft.points[i];
  for (std::size_t i = 0; i < draft.near.size(); ++i) sample.near_boundary[place[i]] = draft.near[i];
  for (Loop& loop : sample.loops) {
    for (Index& id : loop.points) {
      id = place[id];
      sample.boundary[id] = sample.near_boundary[id] = 1;
    }
  }
  return sample;
}

}  // namespace

Sample sample(const SampleOptions& options, const Run& run) try {
  check(options);
  const AnalyticSurface surface = make_surface(options.shape);
  Draft draft = draw_about_n(options, surface, run);
  check_rims(options, draft);
  return finish(std::move(draft), options, run);
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::OutOfMemory, "no memory for a sample of " + std::to_string(options.n) + " points");
}

}  // namespace rimline
