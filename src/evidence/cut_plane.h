// SPDX-License-Identifier: GPL-3.0-or-later
// Detects a plane that has cut the surface, by its rim.
#pragma once

#include <optional>
#include <vector>

#include "local/frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

class CutPlane {
 public:
  // Finds a plane across the surface within about a spacing of all points of a rim; none for rims of few
  // points.
  static std::optional<CutPlane> find(Points points, const Neighbours& neighbours,
                                      const std::vector<double>& spacing, const std::vector<Frame>& frames,
                                      const std::vector<Index>& rim);

  // Distance of a point behind the outermost points of the rim, along the surface, in the spacings around it.
  // Infinite where the surface lies along the plane.
  double depth(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
               const std::vector<Frame>& frames, Index point) const;

 private:
  double sine(const Frame& frame) const;  // of the angle between the surface and the plane

  Point at_, inwards_;
  double outermost_ = 0;  // height of these points, in spacings
};

}  // namespace rimline
