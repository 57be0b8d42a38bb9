// SPDX-License-Identifier: GPL-3.0-or-later
// Prepares the input: checks it, arranges it, finds neighbours and spacing.
#pragma once

#include <algorithm>
#include <vector>

#include "rimline/arrange.h"
#include "rimline/neighbours.h"
#include "rimline/pipeline.h"
#include "rimline/stage_clock.h"

namespace rimline::pipeline {

// The points in use, and their k-nearest graph. All later stages use `points()`; results.h translates results
// to the ids of the input.
struct PreparedPoints {
  Points input;
  Arrangement arrangement;
  Neighbours neighbours;
  std::vector<double> spacing;  // local_spacing()
  SpacingSummary spacing_summary;
  StepSummary steps;

  const std::vector<Point>& points() const { return arrangement.points; }
  const std::vector<Index>& ids() const { return arrangement.ids; }

  // The same as the input has them: `points()` lie elsewhere where terraces were smoothed.
  std::vector<Point> places() const;
};

// Throws BadOption for corners that name points which the input does not have, normals that are not one per
// point, and given loops as check_given_loops() does.
void check_input(Points input, const Options& options, const Given& given);

PreparedPoints prepare(Points input, const Options& options, const Given& given, const Run& run,
                       StageClock& clock);

// Calls body() and returns its result. Errors of the stages name points of the arrangement; their ids are
// translated to those of the input.
template <class Body>
auto with_ids_of_input(const PreparedPoints& prepared, const Body& body) {
  try {
    return body();
  } catch (const Error& error) {
    std::vector<Index> ids;
    for (const Index id : error.ids()) ids.push_back(prepared.ids()[id]);
    std::sort(ids.begin(), ids.end());
    throw Error(error.code(), error.what(), std::move(ids));
  }
}

}  // namespace rimline::pipeline
