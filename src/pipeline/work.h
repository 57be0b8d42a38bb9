// SPDX-License-Identifier: GPL-3.0-or-later
// One run of the method over one input: what the stages have found so far.
#pragma once

#include <algorithm>
#include <vector>

#include "rimline/arrange.h"
#include "rimline/boundary.h"
#include "rimline/exact_loops.h"
#include "rimline/measure.h"
#include "rimline/neighbours.h"
#include "rimline/pipeline.h"
#include "rimline/refine.h"
#include "rimline/stage_clock.h"

namespace rimline::pipeline {

// All ids are those of the arrangement; results.h translates what leaves to the ids of the input.
struct Work {
  Points input;
  const Options& options;
  const Run& run;
  const Given& given;
  Report report = {};
  StageClock clock = {};

  Arrangement arrangement = {};
  Neighbours neighbours = {};
  std::vector<double> spacing = {};
  BoundaryScores scores = {};
  std::vector<float> probability = {};
  std::vector<PointLabel> label = {};
  std::vector<Triangle> surveyed = {};
  bool range_scan = false;
  std::vector<Loop> loops = {};
  std::vector<UV> uv = {};
  std::vector<Index> patch = {};
  std::vector<Triangle> triangles = {};
  std::vector<Index> triangle_patch = {};  // preset `default`
  std::vector<char> filled = {};           // per triangle; preset `default`
  std::vector<Point> vertices = {};        // the points of the arrangement, then those that fills added
  std::vector<HoleFill> fills = {};
  Distortion distortion = {};

  bool is_paper() const { return options.preset != Preset::Default; }
};

// Errors of the stages name points of the arrangement; users know those of their file.
template <class Body>
auto translate_errors(const Work& work, const Body& body) {
  try {
    return body();
  } catch (const Error& error) {
    std::vector<Index> ids;
    for (const Index id : error.ids()) ids.push_back(work.arrangement.ids[id]);
    std::sort(ids.begin(), ids.end());
    throw Error(error.code(), error.what(), std::move(ids));
  }
}

}  // namespace rimline::pipeline
