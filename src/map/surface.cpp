// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "map/patches.h"
#include "map/refine_patch.h"
#include "rimline/refine.h"

namespace rimline {
namespace {

Patch refine_alone(Points points, const PatchInput& input, int k, const RefineOptions& options,
                   const Run& run) {
  std::vector<Point> own;
  own.reserve(input.points.size());
  for (const Index i : input.points) own.push_back(points[i]);
  const Neighbours neighbours = find_neighbours(own, k, run);
  const Stars stars = find_stars(own, neighbours, {}, {}, run);
  return refine_patch(own, neighbours, stars, input.outline, options, run);
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
  const Stars stars = find_stars(points, neighbours, {}, {}, run);
  Partition parts = partition(stars, loops, surface_triangles);
  Surface surface;
  surface.uv.assign(points.size(), {nan, nan});
  surface.patch.assign(points.size(), none);
  surface.left_out = std::move(parts.left_out);
  Row row;
  for (const PatchInput& input : parts.patches) {
    const bool whole = input.points.size() == points.size();
    try {
      Patch patch = whole ? refine_patch(points, neighbours, stars, input.outline, options, run)
                          : refine_alone(points, input, neighbours.k, options, run);
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
