// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/model.h"
#include "base/multiversioning.h"
#include "base/parallel.h"
#include "base/prefault.h"
#include "local/neighbourhood.h"
#include "local/principal_axes.h"

namespace rimline {
namespace {

// Middle over largest eigenvalue below which the neighbours are a line rather than a patch.
constexpr double line = model::frame_line;

// Of the points and the one they are the neighbours of: sums of squares.
Covariance covariance(Points points, Index self, std::span<const Index> ids) {
  constexpr std::size_t most = 40;  // [layout]
  const Point p = points[self];
  std::array<Point, most> room;
  std::vector<Point> more;
  Point* const offset = ids.size() <= most ? room.data() : (more.resize(ids.size()), more.data());
  Point mean;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    offset[i] = points[ids[i]] - p;
    mean = mean + offset[i];
  }
  const double count = static_cast<double>(ids.size() + 1);
  mean = {mean.x / count, mean.y / count, mean.z / count};
  double xx = mean.x * mean.x, xy = mean.x * mean.y, xz = mean.x * mean.z;
  double yy = mean.y * mean.y, yz = mean.y * mean.z, zz = mean.z * mean.z;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Point d = offset[i] - mean;
    xx += d.x * d.x, xy += d.x * d.y, xz += d.x * d.z;
    yy += d.y * d.y, yz += d.y * d.z, zz += d.z * d.z;
  }
  return {xx, xy, xz, yy, yz, zz};
}

// An eigenvector with the sign of a cross product of columns of m - lambda: of the column with the largest
// diagonal entry and the one that makes the larger product with it. Any rule would do except on grids, where
// eigenvalues tie and the signs of axes decide. This is the rule of Eigen's closed form.
inline Point with_sign(Point v, const Covariance& m, double lambda) {
  const Point a{m.xx - lambda, m.xy, m.xz}, b{m.xy, m.yy - lambda, m.yz}, c{m.xz, m.yz, m.zz - lambda};
  const Point ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  const bool b_is_larger = std::abs(b.y) > std::abs(a.x);
  const bool c_is_largest = std::abs(c.z) > (b_is_larger ? std::abs(b.y) : std::abs(a.x));
  const Point next = choose(c_is_largest, ca, choose(b_is_larger, bc, ab));
  const Point other = choose(c_is_largest, bc, choose(b_is_larger, ab, ca));  // the opposite of the product
  const bool takes_next = dot(next, next) > dot(other, other);
  const double side = takes_next ? dot(next, v) : -dot(other, v);
  return (side < 0 ? -1.0 : 1.0) * v;
}

// Fixes the signs of the first and the last axis.
RIMLINE_WIDE void set_signs(const CovarianceLanes& m, PrincipalAxesLanes& axes) {
  for (const int i : {0, 2}) {
    for (int l = 0; l < lanes; ++l) {
      const Point v = with_sign({axes.x[i][l], axes.y[i][l], axes.z[i][l]},
                                {m.xx[l], m.xy[l], m.xz[l], m.yy[l], m.yz[l], m.zz[l]}, axes.lambda[i][l]);
      axes.x[i][l] = v.x;
      axes.y[i][l] = v.y;
      axes.z[i][l] = v.z;
    }
  }
}

Frame frame_of(const PrincipalAxes& axes) {
  Frame frame{axes.v[2], cross(axes.v[0], axes.v[2]), axes.v[0]};
  if (axes.lambda[1] > 0) frame.thickness = std::max(0.0, axes.lambda[0] / axes.lambda[1]);
  return frame;
}

PrincipalAxes axes_of(const Covariance& m) {
  PrincipalAxes axes = principal_axes(m);
  for (const int i : {0, 2}) axes.v[i] = with_sign(axes.v[i], m, axes.lambda[i]);
  return axes;
}

// Takes more neighbours where the few nearest lie nearly on a line.
Frame fit_frame_to_more(Points points, const Neighbours& neighbours, Index point) {
  PrincipalAxes axes;
  for (const int k : {20, 40}) {  // [speed]
    axes = axes_of(covariance(points, point, neighbours.of(point, std::min(k, neighbours.k))));
    if (axes.lambda[1] >= line * axes.lambda[2] || k >= neighbours.k) break;
  }
  return frame_of(axes);
}

}  // namespace

Frame fit_frame(Points points, std::span<const Index> ids, Index point) {
  return frame_of(axes_of(covariance(points, point, ids)));
}

std::vector<Frame> fit_frames(Points points, const Neighbours& neighbours, const Run& run) {
  const int few = std::min(model::few_neighbours, neighbours.k);
  std::vector<Frame> frames;
  resize_together(frames, points.size(), run);
  parallel_slices(points.size(), Stage::Survey, run, [&](std::size_t begin, std::size_t end) {
    Neighbourhoods neighbourhoods(few);
    CovarianceLanes squares;
    PrincipalAxesLanes found;
    for (auto first = static_cast<Index>(begin); first < static_cast<Index>(end); first += lanes) {
      neighbourhoods.gather(points, neighbours, first, static_cast<Index>(end));
      neighbourhoods.sum_squares(few + 1, squares);
      principal_axes(squares, found);
      set_signs(squares, found);
      for (Index i = first; i < std::min(first + lanes, static_cast<Index>(end)); ++i) {
        const PrincipalAxes axes = found.of(i - first);
        const bool is_line = axes.lambda[1] < line * axes.lambda[2];
        frames[i] = is_line && few < neighbours.k ? fit_frame_to_more(points, neighbours, i) : frame_of(axes);
      }
    }
  });
  return frames;
}

}  // namespace rimline
