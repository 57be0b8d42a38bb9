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

// The points in random order and their exact boundary.
struct Sample {
  std::vector<Point> points;
  std::vector<std::uint8_t> boundary;  // 1 on a true loop
  std::vector<Loop> loops;             // ordered, surface on the left, outer loops first
};

// The same options and seed give the same bytes. Throws BadOption where a sampling does not fit a shape or
// n is too small for it.
Sample sample(const SampleOptions& options, const Run& run);

}  // namespace rimline
