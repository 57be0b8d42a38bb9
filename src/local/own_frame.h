// SPDX-License-Identifier: GPL-3.0-or-later
// A coordinate frame of the cloud that is invariant to rotation.
#pragma once

#include <array>
#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

using SecondMoments = std::array<double, 6>;  // xx, xy, xz, yy, yz, zz [layout]
using ThirdMoments = std::array<double, 10>;  // xxx, xxy, xxz, xyy, xyz, xzz, yyy, yyz, yzz, zzz [layout]

// The number of points, their mean, and the sums of products of two and of three coordinates relative to it.
// Moments of parts that share no point, added up, are those of the whole, to rounding (Pebay 2008).
struct Moments {
  double count = 0;
  Point mean{};
  SecondMoments second{};
  ThirdMoments third{};

  Moments& operator+=(const Moments& other);
};

Moments moments_of(Points points, const Run& run);

// The principal axes of all points about their mean, right-handed. Signs are such that the third moments
// along the first two axes are positive. Choices that need a direction, or a subset of the points, are made
// in this frame, so that a rotated cloud gives the same result. Axes of equal length are arbitrary.
struct OwnFrame {
  Point centre;
  std::array<Point, 3> axes{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};  // the longest first
  double extent = 1;    // root of the mean square distance to the centre
  bool is_flat = true;  // whether the points lie in a plane, to rounding
  double count = 0;     // of the points

  // Transforms a vector into the frame, and back.
  Point in(Point v) const { return {dot(v, axes[0]), dot(v, axes[1]), dot(v, axes[2])}; }
  Point out(Point v) const { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }
};

OwnFrame own_frame(const Moments& moments);
OwnFrame own_frame(Points points, const Run& run);

// A pseudorandom number in [0, 1) that depends on the position of the point in the frame. The points with a
// number below a share are a sample of that share, and the same sample where the cloud is rotated.
double strewn(const OwnFrame& frame, Point point);

}  // namespace rimline
