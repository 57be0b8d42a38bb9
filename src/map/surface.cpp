// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "map/patches.h"
#include "map/refine_patch.h"
#include "rimline/refine.h"

namespace rimline {
namespace {

Patch refine_alone(Points points, const PatchInput& input, std::vector<Triangle> survey, int k,
                   const RefineOptions& options, const Run& run) {
  std::vector<Point> own;
  own.reserve(input.points.size());
  for (const Index i : input.points) own.push_back(points[i]);
  const Neighbours neighbours = find_neighbours(own, k, run);
  return refine_patch(own, neighbours, nullptr, input.outline, std::move(survey), options, run);
}

// The triangles of each patch, in its ids. At a point of several patches the other corners decide.
std::vector<std::vector<Triangle>> share_out(const std::vector<Triangle>& triangles, std::size_t points,
                                             const std::vector<PatchInput>& patches) {
  constexpr Index several = -2;
  std::vector<Index> patch_of(points, none), local(points, none);
  for (Index p = 0; p < static_cast<Index>(patches.size()); ++p) {
    for (Index i = 0; i < static_cast<Index>(patches[p].points.size()); ++i) {
      const Index v = patches[p].points[i];
      patch_of[v] = patch_of[v] == none ? p : several;
      local[v] = i;
    }
  }
  std::vector<std::vector<Triangle>> parts(patches.size());
  for (const Triangle& t : triangles) {
    const Index p = std::max({patch_of[t[0]], patch_of[t[1]], patch_of[t[2]]});
    if (p < 0) continue;
    const std::vector<Index>& ids = patches[p].points;
    Triangle own = t;
    bool inside = true;
    for (Index& v : own) {
      inside = inside && (patch_of[v] == p || patch_of[v] == several);
      v = patch_of[v] == p ? local[v]
                           : static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), v) - ids.begin());
    }
    if (inside) parts[p].push_back(own);
  }
  return parts;
}

PatchReport report_on(const PatchInput& input, const Patch& patch, const RefineOptions& options) {
  PatchReport report;
  report.points = input.points.size();
  report.triangles = patch.triangles.size();
  report.loops = input.outline.loops.size();
  report.rounds = patch.rounds;
  report.map = patch.map;
  report.uv_flips = patch.uv_flips;
  report.evened = patch.evened;
  report.domain = patch.domain;
  std::size_t rim = 0, bad = std::numeric_limits<std::size_t>::max();
  for (const Loop& loop : input.outline.loops) rim += loop.points.size();
  for (const RefineRound& round : patch.rounds) bad = std::min(bad, round.bad_edges);
  const double inner = (3.0 * static_cast<double>(patch.triangles.size()) - static_cast<double>(rim)) / 2;
  report.bad_share = inner > 0 ? static_cast<double>(bad) / inner : 0;
  report.suspect = report.bad_share > options.suspect_share;
  return report;
}

// Puts the patches' maps in one row, each in its own box, a tenth of a width apart.
class Row {
 public:
  void place(std::vector<UV>& uv) {
    if (uv.empty()) return;
    const auto [low, high] = std::minmax_element(uv.begin(), uv.end(), [](UV a, UV b) { return a.u < b.u; });
    const double least = low->u, width = high->u - low->u;
    const double shift = first_ ? 0 : at_ - least;
    if (!first_) {
      for (UV& p : uv) p.u += shift;
    }
    at_ = least + shift + 1.1 * width;
    first_ = false;
  }

 private:
  double at_ = 0;
  bool first_ = true;  // the first stays where its map has it
};

}  // namespace

Surface refine_surface(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                       const std::vector<Triangle>& surface_triangles, const RefineOptions& options,
                       const Run& run) {
  if (loops.empty()) throw Error(ErrorCode::NoClosedLoop, "there is no loop: nothing bounds the surface");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::optional<Stars> stars;
  const auto find = [&]() -> const Stars& {
    if (!stars) stars = find_stars(points, neighbours, {}, {}, run);
    return *stars;
  };
  Partition parts = partition(static_cast<Index>(points.size()), find, loops, surface_triangles);
  Surface surface;
  surface.uv.assign(points.size(), {nan, nan});
  surface.patch.assign(points.size(), none);
  surface.left_out = std::move(parts.left_out);
  std::vector<std::vector<Triangle>> surveys = share_out(surface_triangles, points.size(), parts.patches);
  Row row;
  for (std::size_t p = 0; p < parts.patches.size(); ++p) {
    const PatchInput& input = parts.patches[p];
    const bool whole = input.points.size() == points.size();
    try {
      Patch patch = whole ? refine_patch(points, neighbours, stars ? &*stars : nullptr, input.outline,
                                         std::move(surveys[p]), options, run)
                          : refine_alone(points, input, std::move(surveys[p]), neighbours.k, options, run);
      surface.patches.push_back(report_on(input, patch, options));
      row.place(patch.uv);
      for (const Triangle& t : patch.triangles) {
        surface.triangles.push_back({input.points[t[0]], input.points[t[1]], input.points[t[2]]});
      }
      for (std::size_t i = 0; i < input.points.size(); ++i) {
        surface.uv[input.points[i]] = patch.uv[i];
        surface.patch[input.points[i]] = static_cast<Index>(surface.patches.size()) - 1;
      }
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Cancelled || error.code() == ErrorCode::OutOfMemory) throw;
      std::vector<Index> ids;
      for (const Index i : error.ids()) ids.push_back(input.points[i]);
      if (!options.allow_partial) throw Error(error.code(), error.what(), std::move(ids));
      surface.patches.push_back({});
      surface.patches.back().points = input.points.size();
      surface.patches.back().loops = input.outline.loops.size();
      surface.patches.back().failure = error.what();
    }
  }
  return surface;
}

}  // namespace rimline
