// SPDX-License-Identifier: GPL-3.0-or-later
// A draft of a sample: the points in the order of their construction, without noise.
#pragma once

#include <cstdint>
#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"
#include "sample/density.h"
#include "sample/surface.h"

namespace rimline {

struct Draft {
  std::vector<Point> points;
  std::vector<std::vector<Index>> loops;  // in order, surface on the left, the outer one first
  std::vector<std::uint8_t> near;         // 1 within half a spacing of a boundary curve; empty: on loops only
};

// Blue noise: rims walked at one spacing, then darts thrown on the surface until none fits any more, each
// `blue_radius` spacings or more from all others and half a spacing or more from the boundary curves.
struct BlueNoise {
  Draft draft;
  std::vector<UV> uv;  // of the points, in the chart
};
BlueNoise blue_noise(const AnalyticSurface& surface, const Density& density, const Run& run,
                     std::size_t expected);

// Dart throwing jams at 0.6966 points for a square of one radius (0.5471 of the plane covered by discs:
// Torquato, Uche, Stillinger 2006), so this radius gives one point for a square of one spacing.
inline constexpr double blue_radius = 0.8346;

// Rims walked at one spacing and points drawn uniformly by area, `count` in all.
Draft random_points(const AnalyticSurface& surface, double spacing, std::size_t count, const Run& run);

// Rows of points at equal steps and the rims at the same; nodes within half a spacing of a rim are dropped.
// `aspect` is the step across the rows over the step along them; above 1 each row begins at its own phase.
Draft lattice(const AnalyticSurface& surface, double spacing, double aspect, const Run& run,
              std::size_t expected);

// Blue noise on the larger surface without the points outside the smaller one. Loops: points that lost a
// Delaunay neighbour. Points whose remaining triangles do not form one fan are left out too, and all but the
// largest piece.
Draft cropped(Shape shape, double spacing, const Run& run, std::size_t expected);

}  // namespace rimline
