// SPDX-License-Identifier: GPL-3.0-or-later
#include "clouds.h"

#include <cmath>
#include <map>

#include "base/random.h"
#include "rimline/arrange.h"

namespace rimline::bench {

const std::vector<Point>& sheet(int count) {
  static std::map<int, std::vector<Point>> made;
  std::vector<Point>& points = made[count];
  if (points.empty()) {
    Random random(1);
    for (int i = 0; i < count; ++i) {
      const double x = random.uniform(), y = random.uniform();
      points.push_back({x, y, 0.1 * std::sin(5 * x) * std::cos(4 * y)});
    }
  }
  return points;
}

const std::vector<Point>& arranged_sheet(int count) {
  static std::map<int, std::vector<Point>> made;
  std::vector<Point>& points = made[count];
  if (points.empty()) points = arrange(sheet(count), {}).points;
  return points;
}

}  // namespace rimline::bench
