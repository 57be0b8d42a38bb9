// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a surface with their neighbourhoods.
#pragma once

#include <vector>

#include "local/frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Holds references: the points, the lists and the spacings must outlive it.
struct Samples {
  Points points;
  const Neighbours& neighbours;
  const std::vector<double>& spacing;
  std::vector<Frame> frames;
};

inline Samples with_frames(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                           const Run& run) {
  return {points, neighbours, spacing, fit_frames(points, neighbours, run)};
}

}  // namespace rimline
