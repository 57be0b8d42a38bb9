// SPDX-License-Identifier: GPL-3.0-or-later
// Section 6 as an experiment: candidates that are not on the boundary, and windows that are filled.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "paper/point_set.h"
#include "rimline/score_boundary.h"

namespace rimline::bench {

// "undersampled": candidates farther than a spacing from the true rim. "on_creases" of them and "creases" of
// all points: shares within a spacing of an edge of the true mesh that folds by more than 30 degrees.
// "found": the share of the crease points that are such candidates. Null where the true mesh is not known.
nlohmann::ordered_json measure_undersampling(const PointSet& set, const BoundaryScores& scores);

// The mesh of the preset `paper`: of the true "holes" those that are "filled", that is, that have triangles
// with all corners on their rim, and the mesh's "euler" number and "loops". Null where the true mesh is not
// known.
nlohmann::ordered_json measure_windows(const std::string& path, const std::string& truth);

}  // namespace rimline::bench
