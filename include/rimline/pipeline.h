// SPDX-License-Identifier: GPL-3.0-or-later
// The method from end to end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rimline/boundary_loops.h"
#include "rimline/measure.h"
#include "rimline/mesh.h"
#include "rimline/options.h"
#include "rimline/points.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

// All per-point results are in the order and ids of the input. Points that take no part (PointCounts) have
// boundary 0, loop `none`, candidate 0, and NaN for numbers.
struct BoundaryResult {
  std::vector<std::uint8_t> boundary;   // 1 on a returned loop
  std::vector<Index> loop;              // position in `loops`, or `none`
  std::vector<std::uint8_t> candidate;  // 1 where p <= significance
  std::vector<double> p_value;          // of the chi-square test, eq. (1)
  std::vector<double> score;            // eq. (2) in the score form of the options
  std::vector<float>
      boundary_probability;       // that it lies on a boundary, calibrated; empty in the paper's presets
  std::vector<PointLabel> label;  // what the point is; empty in the paper's presets
  std::vector<Loop> loops;
  Report report;
};

struct ParameterizeResult {
  BoundaryResult boundary;
  std::vector<UV> uv;
};

// Loops of holes that were filled are no loops of the result, and their points are not on the boundary.
struct ReconstructResult {
  BoundaryResult boundary;
  std::vector<Point> added;  // vertices that fills have of their own; their ids follow those of the input
  std::vector<UV> uv;        // per point and added one; patches side by side where there are several
  std::vector<Triangle> triangles;
  std::vector<Index> patch;          // likewise, or `none`; empty in the paper's presets
  std::vector<std::uint8_t> filled;  // per triangle, 1 where it closes a hole; empty in the paper's presets
  Distortion distortion;             // per triangle, and per point and added one
};

// A mesh to measure the result against.
struct Reference {
  std::string name;  // for the report
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

// What may come with the points; all may be empty.
struct Given {
  std::vector<Point> normals;  // one per point: the mesh faces the way most of them point
  std::vector<Loop> loops;     // a boundary made by hand, used instead of finding one
  Reference reference;         // for reconstruct
};

// The loops. Under the preset `default` a closed surface gives none, which is an answer and not an error.
// Throws BadOption, TooFewPoints, Cancelled, and under the paper's presets NoClosedLoop.
BoundaryResult find_boundary(Points points, const Options& options, const Run& run, const Given& given = {});

// The loops and the map. Throws also NoClosedLoop, UnreachableInterior, NotADisc, NoConvergence.
ParameterizeResult parameterize(Points points, const Options& options, const Run& run,
                                const Given& given = {});

// The whole method. Throws as parameterize does.
ReconstructResult reconstruct(Points points, const Options& options, const Run& run, const Given& given = {});

}  // namespace rimline
