// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest of some points to a place anywhere.
#pragma once

#include <memory>
#include <vector>

#include "rimline/points.h"

namespace rimline::bench {

class NearestPoint {
 public:
  explicit NearestPoint(std::vector<Point> points);
  ~NearestPoint();
  NearestPoint(NearestPoint&&) noexcept;

  struct Found {
    Index id = none;  // position in the points given; `none` where there are none
    double distance = 0;
  };
  Found to(Point place) const;
  // The nearest `count`, in ascending distance.
  std::vector<Found> to(Point place, std::size_t count) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace rimline::bench
