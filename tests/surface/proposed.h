// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that is proposed through points, with all that it rests on.
#pragma once

#include <utility>
#include <vector>

#include "local/frame.h"
#include "local/star.h"
#include "rimline/neighbours.h"
#include "surface/propose.h"

namespace rimline {

// The set refers to the points and frames beside it: not to be copied.
struct ProposedSurface {
  explicit ProposedSurface(std::vector<Point> through)
      : points(std::move(through)),
        neighbours(find_neighbours(points, 40, {})),
        spacing(local_spacing(points, neighbours)),
        frames(fit_frames(points, neighbours, {})),
        set(propose_surface(points, frames, find_stars(points, neighbours, spacing, frames, {}), spacing, 3,
                            {})) {}
  ProposedSurface(const ProposedSurface&) = delete;
  ProposedSurface& operator=(const ProposedSurface&) = delete;

  std::vector<Point> points;
  Neighbours neighbours;
  std::vector<double> spacing;
  std::vector<Frame> frames;
  TriangleSet set;
};

}  // namespace rimline
