// SPDX-License-Identifier: GPL-3.0-or-later
// The most probable path of a rim through the points about its curve.
#pragma once

#include <cstddef>
#include <vector>

#include "loops/smooth_curve/projections.h"

namespace rimline {

// Noise moves points along the rim as well as across it. Where two of the outermost points lie close
// together, one of them probably comes from behind; where they leave a gap, the outermost point of the gap
// probably belongs to the rim. This is the path around the curve with the greatest sum of log odds of its
// points (by how far out they lie), less the cost of its steps (by the difference of their lengths from 1, as
// normal errors). Found by the Viterbi algorithm (Viterbi 1967) over the points in the order of the curve.
//
// `projections`: from the outermost inwards; `count`: the expected number of points of the rim; `noise`:
// standard deviation of the points over the spacing. Returns the samples along the curve.
std::vector<RimSample> likeliest_path(const RimCurve& curve, const std::vector<Projection>& projections,
                                      std::size_t count, double noise);

}  // namespace rimline
