// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/range_image.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/model.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "local/own_frame.h"
#include "rimline/delaunay.h"

namespace rimline {
namespace {

// Two unit vectors across a unit vector.
std::array<Point, 2> across(Point view) {
  const Point axis =
      std::abs(view.x) < 0.8 ? Point{1, 0, 0} : Point{0, 1, 0};  // [guard] any axis not along it
  const Point u = cross(view, axis), unit = (1 / norm(u)) * u;
  return {unit, cross(view, unit)};
}

double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The sum of what add(i, sum) adds for each i, from parts of the same size for any number of threads.
template <class Sum, class Add>
Sum sum_over(std::size_t count, const Run& run, const Add& add) {
  constexpr std::size_t in_part = 16384;  // [speed]
  std::vector<Sum> parts((count + in_part - 1) / in_part, Sum::Zero());
  parallel_tasks(parts.size(), Stage::Survey, run, [&](std::size_t k) {
    Sum sum = Sum::Zero();  // parts side by side would share a line of the cache
    for (std::size_t i = k * in_part; i < std::min(count, (k + 1) * in_part); ++i) add(i, sum);
    parts[k] = sum;
  });
  run.check_cancel();
  return std::accumulate(parts.begin(), parts.end(), Sum(Sum::Zero()));
}

// The direction in which the points extend least; none where they do not extend in it at all.
std::optional<Point> thinnest(Points points, const Run& run) {
  constexpr double flat = 1e-12;  // of the variance in the middle direction [guard]
  const auto at = [&](std::size_t i) { return Eigen::Vector3d(points[i].x, points[i].y, points[i].z); };
  const Eigen::Vector3d mean =
      sum_over<Eigen::Vector3d>(points.size(), run, [&](std::size_t i, Eigen::Vector3d& s) { s += at(i); }) /
      static_cast<double>(points.size());
  const auto sum = sum_over<Eigen::Matrix3d>(points.size(), run, [&](std::size_t i, Eigen::Matrix3d& s) {
    const Eigen::Vector3d d = at(i) - mean;
    s += d * d.transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  if (solver.eigenvalues()[0] <= flat * solver.eigenvalues()[1]) return std::nullopt;
  const Eigen::Vector3d least = solver.eigenvectors().col(0);
  return Point{least.x(), least.y(), least.z()};
}

// How the neighbours of some of the samples lie in the cloud's own frame, for a quick look from any side.
class Look {
 public:
  Look(Points points, const Neighbours& neighbours, const OwnFrame& own, std::size_t samples,
       const Run& run) {
    const int k = std::min(model::few_neighbours, neighbours.k);
    std::vector<double> in_space;
    for (const Index i : some_of(points, own, samples, run)) {
      for (const Index j : neighbours.of(i, k)) steps_.push_back(own.in(points[j] - points[i]));
      in_space.push_back(distance_to(points, neighbours, i, 0));
    }
    least_ = 0.5 * quantile(in_space, 0.5);
    per_sample_ = k;
  }

  // The distance of each sample to the nearest of its neighbours, seen along `view`.
  std::vector<double> nearest(Point view) const {
    std::vector<double> result;
    for (std::size_t first = 0; first < steps_.size(); first += per_sample_) {
      double least = 1e300;
      for (std::size_t i = first; i < first + per_sample_; ++i) {
        const double along = dot(steps_[i], view);
        least = std::min(least, dot(steps_[i], steps_[i]) - along * along);
      }
      result.push_back(std::sqrt(std::max(0.0, least)));
    }
    return result;
  }

  // The spread of these distances over their median, and the same of the gaps between rows: 0 for a raster.
  // The steps along rows alone do not tell where across them the view is from.
  double spread(Point view) const {
    std::vector<double> all = nearest(view);
    if (quantile(all, 0.5) < least_) return 1e300;  // [layout] a spread
    constexpr double most = 4;                      // of the gaps, which are asked only where steps are even
    const double along_rows = relative_spread(all);
    if (along_rows > model::range_nearly) return along_rows + most;
    std::vector<double> gaps = to_next_row(view);
    return along_rows + (gaps.empty() ? most : std::min(most, relative_spread(gaps)));
  }

  // The median of these distances, where nearly all are equal to it.
  std::optional<double> step(Point view) const {
    constexpr double tolerance = model::range_step_tolerance, least_share = model::range_step_share;
    std::vector<double> all = nearest(view);
    const double middle = quantile(all, 0.5);
    const auto agree = std::count_if(all.begin(), all.end(),
                                     [&](double d) { return std::abs(d - middle) <= tolerance * middle; });
    const bool even = static_cast<double>(agree) >= least_share * static_cast<double>(all.size());
    return middle >= least_ && even ? std::optional(middle) : std::nullopt;
  }

 private:
  static double relative_spread(std::vector<double>& values) {
    return (quantile(values, 0.9) - quantile(values, 0.1)) / quantile(values, 0.5);  // [layout]
  }

  // How far beside the line through a sample and its nearest neighbour the next row is, seen along `view`:
  // the least over its other neighbours that are not about in the line.
  std::vector<double> to_next_row(Point view) const {
    constexpr double in_line = model::range_in_line * model::range_in_line;
    std::vector<double> result;
    std::vector<Point> seen(per_sample_);
    for (std::size_t first = 0; first < steps_.size(); first += per_sample_) {
      for (std::size_t i = 0; i < per_sample_; ++i)
        seen[i] = steps_[first + i] - dot(steps_[first + i], view) * view;
      const Point row = *std::ranges::min_element(seen, {}, [](Point p) { return dot(p, p); });
      double least = 1e300;
      for (const Point p : seen) {
        const Point off = cross(row, p);
        const double squared = dot(off, off);
        if (squared > in_line * dot(row, row) * dot(p, p)) least = std::min(least, squared / dot(row, row));
      }
      if (least < 1e300) result.push_back(std::sqrt(least));
    }
    return result;
  }

  std::vector<Point> steps_;
  std::size_t per_sample_;
  double least_;  // a view along a row sees its samples behind one another
};

struct View {
  double spread;
  Point direction;
};

// Directions spread evenly over half the sphere (a Fibonacci lattice), the least spread first.
std::vector<View> look_around(const Look& look, const Run& run) {
  constexpr int directions = 400;  // [speed]
  std::vector<View> views(directions);
  parallel_tasks(views.size(), Stage::Survey, run, [&](std::size_t i) {
    const double at = static_cast<double>(i) + 0.5, z = at / directions, r = std::sqrt(1 - z * z);
    const double angle = std::numbers::pi * (1 + std::sqrt(5.0)) * at;  // [layout] golden angle
    const Point direction{r * std::cos(angle), r * std::sin(angle), z};
    views[i] = {look.spread(direction), direction};
  });
  std::stable_sort(views.begin(), views.end(),
                   [](const View& a, const View& b) { return a.spread < b.spread; });
  return views;
}

// Walks to the least spread near a view, in ever smaller steps.
View settle(const Look& look, View view) {
  double stride = 0.1;                             // radians [speed]
  for (int step = 0; step < 200 && stride > 1e-4;  // [guard]
       ++step) {                                   // bounded, as rounding may lead in a circle [guard]
    const auto [u, v] = across(view.direction);
    bool better = false;
    for (int k = 0; k < 8 && !better; ++k) {  // [speed]
      const double angle = k * std::numbers::pi / 4;
      const Point to = view.direction + stride * (std::cos(angle) * u + std::sin(angle) * v);
      const Point unit = (1 / norm(to)) * to;
      const double spread = look.spread(unit);
      better = spread < view.spread;
      if (better) view = {spread, unit};
    }
    if (!better) stride /= 2;
  }
  return view;
}

double area(UV a, UV b, UV c) { return 0.5 * std::abs(twice_area(a, b, c)); }

double circumradius(UV a, UV b, UV c) {
  return rimline::circumradius(Point{a.u, a.v, 0}, Point{b.u, b.v, 0}, Point{c.u, c.v, 0});
}

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

// Where rims touch in a point, leaves out all fans there but the largest, so that they become one rim and
// the surface a manifold. What that uncovers is looked at again.
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

// The triangles between neighbouring samples, where the view is a raster in both directions: of all triangles
// of its Delaunay triangulation most are half a cell. (A tunnel sampled in rows shows even steps along these
// from many sides.)
std::vector<Triangle> triangles_of_cells(Points points, const OwnFrame& own, Point direction, double step,
                                         const Run& run) {
  constexpr double largest = model::range_cell_largest, jump = model::range_jump;
  constexpr double tolerance = model::range_cell_tolerance, most = model::range_cell_share;
  constexpr double fewest_jumps = model::range_fewest_jumps, most_slight = model::range_most_slight;
  const auto [u, v] = across(direction);
  std::vector<UV> seen;
  for (const Point& p : points) {
    const Point at = own.in(p - own.centre);
    const double x = dot(at, u), y = dot(at, v);
    // The four corners of a cell lie on a circle: moved by less than a sample's error they do so no more, and
    // a turn of the cloud does not decide which diagonal is taken.
    const double wave = std::sin(17.3 / step * x + 29.9 / step * y);  // [guard]
    const double moved = 1e-4 * step * wave;                          // [guard]
    seen.push_back({x + moved, y});
  }
  std::vector<Triangle> triangles = delaunay(seen, run);
  if (triangles.empty()) return {};
  std::vector<double> areas, radii;
  for (const Triangle& t : triangles) {
    areas.push_back(area(seen[t[0]], seen[t[1]], seen[t[2]]));
    radii.push_back(circumradius(seen[t[0]], seen[t[1]], seen[t[2]]));
  }
  std::vector<double> sorted = areas;
  const double half_cell = quantile(sorted, 0.5);
  sorted = radii;
  const double radius = quantile(sorted, 0.5);
  const auto even = std::count_if(areas.begin(), areas.end(),
                                  [&](double a) { return std::abs(a - half_cell) <= tolerance * half_cell; });
  if (static_cast<double>(even) < most * static_cast<double>(areas.size())) return {};
  std::size_t kept = 0, jumps = 0, slight = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (areas[i] > largest * half_cell || radii[i] > largest * radius) continue;
    slight += areas[i] < (1 - tolerance) * half_cell;
    const Triangle& t = triangles[i];
    const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    if (longest > jump * step) {
      ++jumps;
    } else {
      triangles[kept++] = t;
    }
  }
  // A surface sampled on a grid, with a rim that is not of it, is best left to sizes in space.
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(triangles.size());
  };
  if (share(slight) > most_slight && share(jumps) < fewest_jumps) return {};
  triangles.resize(kept);
  return triangles;
}

}  // namespace

std::optional<RangeImage> find_range_image(Points points, const Neighbours& neighbours, const Run& run) {
  constexpr std::size_t quick = 500, thorough = 5000;  // [speed] samples
  constexpr int starts = 4;
  if (neighbours.size() < model::range_fewest_points) return std::nullopt;
  const OwnFrame own = own_frame(points, run);
  const Look all(points, neighbours, own, thorough, run);
  const auto raster = [&](Point direction) -> std::optional<RangeImage> {
    const auto step = all.step(direction);
    if (!step) return std::nullopt;
    auto triangles = triangles_of_cells(points, own, direction, *step, run);
    if (triangles.empty()) return std::nullopt;
    return RangeImage{own.out(direction), *step, std::move(triangles)};
  };
  const auto front = thinnest(points, run);
  if (!front) return std::nullopt;
  // A nearly flat lattice is one from many sides; only this one sees it in full.
  if (auto found = raster(own.in(*front))) return found;
  const Look look(points, neighbours, own, quick, run);
  const std::vector<View> views = look_around(look, run);
  View best = views[0];
  for (int i = 0; i < starts; ++i) {
    const View view = settle(look, views[i]);
    if (view.spread < best.spread) best = view;
  }
  if (best.spread < model::range_nearly) best = settle(all, {all.spread(best.direction), best.direction});
  return raster(best.direction);
}

TriangleSet range_image_triangles(Points points, const std::vector<Frame>& frames, const RangeImage& raster) {
  TriangleSet set(points, frames);
  for (const Triangle& t : raster.triangles) set.add(t);
  open_pinches(set);
  return set;
}

}  // namespace rimline
