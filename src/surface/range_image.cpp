// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/range_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/model.h"
#include "base/parallel.h"
#include "base/quantile.h"
#include "base/vec.h"
#include "rimline/delaunay.h"

namespace rimline {
namespace {

// The fans at a vertex: triangles that follow each other over shared edges.
std::vector<std::vector<Index>> fans(const TriangleSet& set, Index vertex) {
  std::vector<std::vector<Index>> result;
  std::vector<Index> left(set.star(vertex).begin(), set.star(vertex).end());
  while (!left.empty()) {
    std::vector<Index> fan{left.back()};
    left.pop_back();
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const auto beside = [&](Index t) {
        for (int e = 0; e < 3; ++e) {
          if (set.across(fan[i], e) == t) return true;
        }
        return false;
      };
      for (std::size_t j = 0; j < left.size();) {
        if (beside(left[j])) {
          fan.push_back(left[j]);
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(j));
        } else {
          ++j;
        }
      }
    }
    result.push_back(std::move(fan));
  }
  return result;
}

// Where rims touch in a point, removes all fans there but the largest, so that the rims become one and the
// surface a manifold. Vertices that lose triangles are tested again.
void open_pinches(TriangleSet& set) {
  bool open = true;
  while (open) {
    open = false;
    std::vector<std::uint8_t> kept(static_cast<std::size_t>(set.size()), 1);
    for (Index v = 0; v < set.vertices(); ++v) {
      auto at = fans(set, v);
      if (at.size() < 2) continue;
      open = true;
      const auto largest = std::max_element(at.begin(), at.end(), [](const auto& a, const auto& b) {
        return std::pair(a.size(), b) < std::pair(b.size(), a);
      });
      for (auto fan = at.begin(); fan != at.end(); ++fan) {
        if (fan == largest) continue;
        for (const Index t : *fan) kept[t] = 0;
      }
    }
    if (open) set.keep_only(kept);
  }
}

// The projection of each point along the view. The four corners of a cell are cocircular; they are moved by
// less than a sample's error, so that a rotation of the cloud does not decide which diagonal is taken.
std::vector<UV> seen_along(Points points, const OwnFrame& own, const RangeView& view) {
  const auto [u, v] = axes_across(view.direction);
  std::vector<UV> seen;
  seen.reserve(points.size());
  for (const Point& p : points) {
    const Point at = own.in(p - own.centre);
    const double x = dot(at, u), y = dot(at, v);
    const double wave = std::sin(17.3 / view.step * x + 29.9 / view.step * y);  // [guard]
    seen.push_back({x + 1e-4 * view.step * wave, y});                           // [guard]
  }
  return seen;
}

RangeCell measure_cell(Points points, const std::vector<UV>& seen, const Triangle& t) {
  const auto flat = [&](int c) { return Point{seen[t[c]].u, seen[t[c]].v, 0}; };
  const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
  return {0.5 * std::abs(twice_area(seen[t[0]], seen[t[1]], seen[t[2]])),
          circumradius(flat(0), flat(1), flat(2)),
          std::max({distance(a, b), distance(b, c), distance(c, a)})};
}

}  // namespace

CellSample& CellSample::operator+=(const CellSample& other) {
  cells.insert(cells.end(), other.cells.begin(), other.cells.end());
  return *this;
}

CellSample sample_cells(Points points, const std::vector<Triangle>& triangles, const std::vector<UV>& seen,
                        const OwnFrame& own, const Run& run) {
  constexpr double most = 200000;  // triangles [speed]
  const double share = most / (2 * own.count);
  return {parallel_gather<RangeCell>(
      triangles.size(), Stage::Survey, run, [&](Index i, std::vector<RangeCell>& found) {
        const Triangle& t = triangles[i];
        const Point middle = (1.0 / 3) * (points[t[0]] + points[t[1]] + points[t[2]]);
        if (share < 1 && strewn(own, middle) >= share) return;
        found.push_back(measure_cell(points, seen, t));
      })};
}

std::optional<RangeCell> largest_cell(const CellSample& sample, double step) {
  constexpr double largest = model::range_cell_largest, jump = model::range_jump;
  constexpr double tolerance = model::range_cell_tolerance, most = model::range_cell_share;
  constexpr double fewest_jumps = model::range_fewest_jumps, most_slight = model::range_most_slight;
  if (sample.cells.empty()) return std::nullopt;
  std::vector<double> areas, radii;
  for (const RangeCell& cell : sample.cells) {
    areas.push_back(cell.area);
    radii.push_back(cell.radius);
  }
  const double half_cell = quantile(areas, 0.5), radius = quantile(radii, 0.5);
  const RangeCell limit{largest * half_cell, largest * radius, jump * step};
  std::size_t even = 0, jumps = 0, slight = 0;
  for (const RangeCell& cell : sample.cells) {
    even += std::abs(cell.area - half_cell) <= tolerance * half_cell;
    if (cell.area > limit.area || cell.radius > limit.radius) continue;
    slight += cell.area < (1 - tolerance) * half_cell;
    jumps += cell.longest > limit.longest;
  }
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(sample.cells.size());
  };
  if (share(even) < most) return std::nullopt;
  // A surface sampled on a grid, with a rim that does not follow the grid, is better triangulated by sizes in
  // space.
  if (share(slight) > most_slight && share(jumps) < fewest_jumps) return std::nullopt;
  return limit;
}

namespace {

// The range image along a view, where the samples are a raster in both directions: most triangles of the
// Delaunay triangulation are half a cell. (A tunnel sampled in rows has even steps along these from many
// sides.)
std::optional<RangeImage> raster_along(const RangeView& view, Points points, const OwnFrame& own,
                                       const Run& run) {
  const std::vector<UV> seen = seen_along(points, own, view);
  std::vector<Triangle> triangles = delaunay(seen, run);
  const auto limit = largest_cell(sample_cells(points, triangles, seen, own, run), view.step);
  if (!limit) return std::nullopt;
  std::erase_if(triangles, [&](const Triangle& t) {
    const RangeCell cell = measure_cell(points, seen, t);
    return cell.area > limit->area || cell.radius > limit->radius || cell.longest > limit->longest;
  });
  if (triangles.empty()) return std::nullopt;
  return RangeImage{own.out(view.direction), view.step, std::move(triangles)};
}

}  // namespace

std::optional<RangeImage> find_range_image(Points points, const Neighbours& neighbours, const Run& run) {
  if (neighbours.size() < model::range_fewest_points) return std::nullopt;
  const OwnFrame own = own_frame(points, run);
  if (own.is_flat) return std::nullopt;
  std::vector<Index> all(points.size());
  std::iota(all.begin(), all.end(), Index{0});
  const ViewSample sample = sample_views(points, all, neighbours, own, run);
  if (const auto view = view_from_front(sample)) {
    if (auto found = raster_along(*view, points, own, run)) return found;
  }
  const auto view = best_view(sample, run);
  return view ? raster_along(*view, points, own, run) : std::nullopt;
}

TriangleSet range_image_triangles(Points points, const std::vector<Frame>& frames, const RangeImage& raster) {
  TriangleSet set(points, frames);
  for (const Triangle& t : raster.triangles) set.add(t);
  open_pinches(set);
  return set;
}

}  // namespace rimline
