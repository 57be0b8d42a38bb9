// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that is proposed through points, with all that it rests on.
#pragma once

#include <utility>
#include <vector>

#include "exact/frame.h"
#include "exact/propose.h"
#include "exact/star.h"
#include "rimline/neighbours.h"

namespace rimline::exact {

// The complex refers to the points and frames beside it: not to be copied.
struct Surface {
  explicit Surface(std::vector<Point> through)
      : points(std::move(through)),
        neighbours(find_neighbours(points, 40, {})),
        spacing(local_spacing(points, neighbours)),
        frames(fit_frames(points, neighbours, {})),
        complex(propose_surface(points, frames, find_stars(points, neighbours, spacing, frames, {}), spacing,
                                3, {})) {}
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  std::vector<Point> points;
  Neighbours neighbours;
  std::vector<double> spacing;
  std::vector<Frame> frames;
  Complex complex;
};

}  // namespace rimline::exact
