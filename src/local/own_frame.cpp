// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/own_frame.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "local/principal_axes.h"

namespace rimline {
namespace {

struct Squares {
  Point same, different;  // sums of xx, yy, zz and of xy, xz, yz
};

Point operator+=(Point& sum, Point p) { return sum = sum + p; }
void operator+=(Squares& sum, const Squares& s) { sum.same += s.same, sum.different += s.different; }

// The sum of what of(p) gives for each point, from parts of the same size for any number of threads.
template <class Sum, class Of>
Sum sum_over(Points points, const Run& run, const Of& of) {
  constexpr std::size_t in_part = 16384;  // [speed]
  std::vector<Sum> parts((points.size() + in_part - 1) / in_part);
  parallel_tasks(parts.size(), Stage::Survey, run, [&](std::size_t k) {
    Sum sum;  // parts side by side would share a line of the cache
    for (const Point p : points.subspan(k * in_part, std::min(in_part, points.size() - k * in_part)))
      sum += of(p);
    parts[k] = sum;
  });
  run.check_cancel();
  Sum sum;
  for (const Sum& part : parts) sum += part;
  return sum;
}

Point cubed(Point v) { return {v.x * v.x * v.x, v.y * v.y * v.y, v.z * v.z * v.z}; }

// Where a point is in steps of a 3,000th of the extent, mixed to a number in [0, 1): points side by side
// differ, and rounding changes hardly any.
double mixed(const OwnFrame& frame, Point p) {
  constexpr double steps = 3000, a = 0.7548776662466927, b = 0.5698402909980532;  // [layout]
  const Point at = (steps / frame.extent) * frame.in(p - frame.centre);
  const double mix = a * at.x + b * at.y + (1 - b) * at.z;
  return mix - std::floor(mix);
}

}  // namespace

OwnFrame own_frame(Points points, const Run& run) {
  OwnFrame frame;
  const double share = 1 / static_cast<double>(points.size());
  frame.centre = share * sum_over<Point>(points, run, [](Point p) { return p; });
  const Squares sum = sum_over<Squares>(points, run, [&](Point p) {
    const Point d = p - frame.centre;
    return Squares{{d.x * d.x, d.y * d.y, d.z * d.z}, {d.x * d.y, d.x * d.z, d.y * d.z}};
  });
  const Point squares = share * sum.same, products = share * sum.different;
  const double extent = std::sqrt(squares.x + squares.y + squares.z);
  if (!(extent > 0) || !std::isfinite(extent)) return frame;
  frame.extent = extent;
  const PrincipalAxes found =
      principal_axes({squares.x, products.x, products.y, squares.y, products.z, squares.z});
  frame.axes = {found.v[2], found.v[1], cross(found.v[2], found.v[1])};
  const Point skew =
      sum_over<Point>(points, run, [&](Point p) { return cubed((1 / extent) * frame.in(p - frame.centre)); });
  if (skew.x < 0) frame.axes[0] = -1 * frame.axes[0];
  if (skew.y < 0) frame.axes[1] = -1 * frame.axes[1];
  frame.axes[2] = cross(frame.axes[0], frame.axes[1]);
  return frame;
}

std::vector<Index> some_of(Points points, const OwnFrame& frame, std::size_t most, const Run& run) {
  std::vector<Index> all(points.size() <= most ? points.size() : 0);
  std::iota(all.begin(), all.end(), 0);
  if (!all.empty()) return all;
  const double share = static_cast<double>(most) / static_cast<double>(points.size());
  std::vector<Index> some =
      parallel_gather<Index>(points.size(), Stage::Survey, run, [&](Index i, std::vector<Index>& found) {
        if (mixed(frame, points[i]) < share) found.push_back(i);
      });
  if (some.empty()) some.push_back(0);
  return some;
}

}  // namespace rimline
