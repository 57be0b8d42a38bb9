// SPDX-License-Identifier: GPL-3.0-or-later
// From points to boundary loops.
#pragma once

#include <cstdint>
#include <vector>

#include "rimline/boundary_loops.h"
#include "rimline/given.h"
#include "rimline/history.h"
#include "rimline/mesh.h"
#include "rimline/options.h"
#include "rimline/points.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

// All per-point results have the order and ids of the input. Points that are not used (PointCounts) have
// boundary 0, loop `none`, candidate 0, and NaN for numbers.
struct BoundaryResult {
  std::vector<std::uint8_t> boundary;       // 1 on a returned loop
  std::vector<Index> loop;                  // position in `loops`, or `none`
  std::vector<std::uint8_t> candidate;      // 1 where p <= significance
  std::vector<double> p_value;              // of the chi-square test, eq. (1)
  std::vector<double> score;                // eq. (2) in the score form of the options
  std::vector<float> boundary_probability;  // that the point is on a boundary, calibrated; empty in the paper's presets
  std::vector<PointLabel> label;            // the kind of the point; empty in the paper's presets
  std::vector<std::uint8_t> chromosome;     // 1 where the winner's bit is set; empty but where the paper's
                                            // presets looked for a loop
  SearchHistory history;                    // likewise
  std::vector<Loop> loops;  // those of the paper's presets, and those made by hand, have the probability NaN
  Report report;
};

// The loops. Under the preset `default` a closed surface gives none, which is an answer and not an error.
// Throws BadOption, TooFewPoints, Cancelled, and under the paper's presets NoClosedLoop.
BoundaryResult find_boundary(Points points, const Options& options, const Run& run, const Given& given = {});

}  // namespace rimline
