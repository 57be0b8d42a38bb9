// SPDX-License-Identifier: GPL-3.0-or-later
// The plane that a surface was cut by, as its rim shows it.
#pragma once

#include <optional>
#include <vector>

#include "local/frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"

namespace rimline {

class CutPlane {
 public:
  // Where the points of a rim lie within about a spacing of one plane all along that goes across the surface;
  // rims of few points do not tell.
  static std::optional<CutPlane> find(Points points, const Neighbours& neighbours,
                                      const std::vector<double>& spacing, const std::vector<Frame>& frames,
                                      const std::vector<Index>& rim);

  // How far a point lies behind the outermost points of the rim, along the surface, in the spacings around
  // it. Infinite where the surface lies along the plane.
  double depth(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
               const std::vector<Frame>& frames, Index point) const;

 private:
  double sine(const Frame& frame) const;  // of the angle between the surface and the plane

  Point at_, inwards_;
  double outermost_ = 0;  // height of these points, in spacings
};

}  // namespace rimline
