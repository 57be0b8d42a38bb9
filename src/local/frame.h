// SPDX-License-Identifier: GPL-3.0-or-later
// The tangent plane of a point, estimated from its neighbours.
#pragma once

#include <span>
#include <vector>

#include "base/model.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// A right-handed orthonormal frame. The sign of the normal is arbitrary.
struct Frame {
  Point u, v, normal;
  double thickness = 0;  // least over middle eigenvalue of the covariance, in [0, 1]: 0 is flat
};

// Whether the neighbourhood is not a disc: the surface folds there, or two sheets are close.
inline bool is_folded(const Frame& frame) { return frame.thickness > model::frame_folded; }

// Principal directions of the point and the given others.
Frame fit_frame(Points points, std::span<const Index> others, Index point);

// Frames of all points and their neighbours. Takes the 12 nearest, and more (up to all in the list) where
// these lie nearly on a line, as on scan lines that are far apart.
std::vector<Frame> fit_frames(Points points, const Neighbours& neighbours, const Run& run);

}  // namespace rimline
