// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2.4 as an experiment: what Theorem 2.8 asks of a sample, and the test with its start angle turned.
#pragma once

#include <nlohmann/json.hpp>

#include "paper/point_set.h"
#include "rimline/score_boundary.h"

namespace rimline::bench {

// The test of section 2.3 with the first sector turned by half a sector.
BoundaryScores turned_scores(const PointSet& set, const BoundaryOptions& options);

// "recall" of the true boundary points, the share of them with an "empty_sector", the least "delta" of all
// points, the least opening "R" of a true boundary point in radians, and the "r" that Theorem 2.8 asks for
// with these and gamma = 0. Null where the truth is not known.
nlohmann::ordered_json measure_theory(const PointSet& set, const BoundaryScores& scores,
                                      const BoundaryOptions& options);

}  // namespace rimline::bench
