// SPDX-License-Identifier: GPL-3.0-or-later
// Analytic open surfaces, sampled, with their exact boundary: test data that needs no download.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

enum class Shape {
  FlatDisc,
  BumpySquare,
  WavySaddle,
  HemisphereCap,
  SphereMinusCap,
  HalfTunnel,
  CurledStrip,
  Pipe,
  SquareWithHoles,
  CappedTube,  // ten open surfaces
  ClosedSphere,
  TorusMinusCap,
  MoebiusStrip  // three that are no disc: closed, with a handle, one-sided
};

enum class Sampling { BlueNoise, Random, Grid, SmoothDensity, DensityStep, ScanLines, Cropped };

// "flat-disc", "blue-noise", ...: the names that the tool takes.
const char* name(Shape shape);
const char* name(Sampling sampling);
const std::vector<Shape>& all_shapes();
const std::vector<Sampling>& all_samplings();

struct SampleOptions {
  Shape shape = Shape::FlatDisc;
  Sampling sampling = Sampling::BlueNoise;
  std::size_t n = 10000;  // points wanted; the result has about as many (exact count is in the result)
  double noise = 0;       // standard deviation of isotropic Gaussian noise, in units of the local mean
                          // nearest-neighbour distance
};

// The points in random order, and their exact boundary. Noise changes the points alone.
struct Sample {
  std::vector<Point> points;
  std::vector<std::uint8_t> boundary;  // 1 on a true loop
  // 1 on a true loop and at interior points within half a spacing of the boundary curve; the spacing is
  // 1 / sqrt(points per unit of area). Only Random has such interior points; elsewhere equal to `boundary`.
  std::vector<std::uint8_t> near_boundary;
  // Ordered, surface on the left, length without noise. The first is the outer one, the others are holes:
  // of a pipe the lower rim is the outer one; where there is one loop it is outer.
  std::vector<Loop> loops;
};

// The same options and seed give the same bytes. Throws BadOption where a sampling does not fit a shape, n is
// not in 50 to 1e9, or n is too small for the shape's shortest loop; OutOfMemory.
Sample sample(const SampleOptions& options, const Run& run);

}  // namespace rimline
