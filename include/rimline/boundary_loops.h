// SPDX-License-Identifier: GPL-3.0-or-later
// Every boundary loop of the surface, in order: the default method.  [ours; docs/default-method.md]
#pragma once

#include <cstdint>
#include <vector>

#include "rimline/given.h"
#include "rimline/mesh.h"
#include "rimline/neighbours.h"
#include "rimline/options.h"
#include "rimline/points.h"
#include "rimline/report.h"
#include "rimline/run.h"
#include "rimline/score_boundary.h"

namespace rimline {

// The kind of a point, judged by its neighbourhood.
enum class PointLabel : std::uint8_t {
  Interior = 0,
  Boundary = 1,      // on a returned loop
  Undersampled = 2,  // at a gap in the sampling that is probably no boundary
  Crease = 3,        // at a gap where the surface folds or two sheets are close: sharp edges, thin walls
  Stray = 4,         // in no triangle, or in a component that is too small
};

// "interior", "boundary", "undersampled", "crease", "stray".
const char* name(PointLabel label);

// One connected part of the surface.
struct SurfaceComponent {
  std::size_t points = 0, triangles = 0;
  long long euler = 0;  // V - E + F of its triangles, gaps of sampling and all
  int loops = 0;        // returned ones
  bool orientable = true;
};

// The genetic search, over all groups of candidate triangles.
struct SelectionSummary {
  std::size_t doubtful = 0;         // candidate triangles: the bits of the chromosomes
  std::size_t groups = 0;           // groups of candidates that do not influence each other
  double greedy = 0, best = 0;      // fitness of the choice by size alone, and of the best chromosomes
  std::vector<Generation> history;  // summed over the groups
};

struct BoundaryLoops {
  std::vector<Loop> loops;     // by component, the outer one first, holes by falling length
  std::vector<Loop> doubtful;  // gaps that were taken for none, but may be boundaries: the likeliest first
  std::vector<float> probability;  // per point, that it lies on a boundary, in [0, 1]
  std::vector<PointLabel> label;   // per point
  std::vector<SurfaceComponent> components;
  std::vector<Triangle>
      triangles;  // the surface that the loops bound, oriented per component; gaps are left open
  SelectionSummary search;
  bool closed = false;      // there are no loops, and most points lie on closed surfaces
  bool range_scan = false;  // the points are a range image; those in no triangle are not on the surface
};

// Finds the loops of any number of open surfaces; none where all are closed. Requires finite and distinct
// points and lists of at least 16 neighbours (40 where the density changes sharply), or of all where there
// are fewer. The result depends on run.seed. Throws TooFewPoints for fewer than 4 points and BadOption.
// The first part of the work, the triangles between neighbours that the loops are then sought among, reports
// its progress as Stage::Survey, the rest as Stage::Loops.
// Loop::fitness is eq. (3) on the log score -log(1 - probability), with `length_exponent` as its exponent.
BoundaryLoops find_boundary_loops(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                                  const BoundaryLoopOptions& options, double length_exponent, const Run& run);
// The same, given the local_spacing() of the points, and the scanner's raster (Given::raster) where there is one.
BoundaryLoops find_boundary_loops(Points points, const Neighbours& neighbours, std::vector<double> spacing,
                                  const BoundaryScores& scores, const BoundaryLoopOptions& options,
                                  double length_exponent, const Run& run,
                                  const std::vector<RasterCell>& raster = {});

}  // namespace rimline
