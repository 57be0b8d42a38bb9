// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/orientation.h"

#include <algorithm>
#include <limits>

#include "map/pack.h"
#include "rimline/triangulate.h"

namespace rimline::pipeline {
namespace {

// One per vertex; those that fills added have none of their own.
std::vector<Point> arranged_normals(const Work& work) {
  std::vector<Point> normals;
  if (work.given.normals.empty()) return normals;
  for (const Index id : work.arrangement.ids) normals.push_back(work.given.normals[id]);
  normals.resize(work.vertices.size());
  return normals;
}

// The height about which a map is mirrored: the axis, where only signs change, or the middle of a box that
// stands on it.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

std::vector<Range> ranges_of(const Work& work, std::size_t count) {
  const bool box = work.options.map.domain == Domain::Square || work.options.map.domain == Domain::Rectangle;
  if (!box) return std::vector<Range>(count, Range{0, 0});
  std::vector<Range> ranges(count);
  for (std::size_t i = 0; i < work.uv.size(); ++i) {
    if (!work.patch.empty() && work.patch[i] == none) continue;
    Range& range = ranges[work.patch.empty() ? 0 : work.patch[i]];
    range.low = std::min(range.low, work.uv[i].v);
    range.high = std::max(range.high, work.uv[i].v);
  }
  return ranges;
}

// Seen from the side it faces, the map of a patch that was turned round is mirrored too: triangles stay
// counter-clockwise in uv, and loops keep the surface on their left.
void mirror(Work& work, const std::vector<char>& turned) {
  const auto is_turned = [&](Index point) {
    if (work.patch.empty()) return turned[0] != 0;
    return work.patch[point] != none && turned[work.patch[point]] != 0;
  };
  const std::vector<Range> ranges = ranges_of(work, turned.size());
  for (Index i = 0; i < static_cast<Index>(work.uv.size()); ++i) {
    if (!is_turned(i)) continue;
    const Range& range = ranges[work.patch.empty() ? 0 : work.patch[i]];
    work.uv[i].v = range.low + range.high - work.uv[i].v;
  }
  for (Loop& loop : work.loops) {
    if (is_turned(loop.points.front())) std::reverse(loop.points.begin() + 1, loop.points.end());
  }
}

}  // namespace

void orient_whole(Work& work) {
  const std::vector<Point> normals = arranged_normals(work);
  if (orient_mesh(work.vertices, work.triangles, normals, work.options.mesh.up)) {
    mirror(work, {1});
  }
}

void orient_patches(Work& work, std::size_t count) {
  const std::vector<Point> normals = arranged_normals(work);
  std::vector<char> turned(count, 0);
  auto from = work.triangles.begin();
  for (std::size_t begin = 0; begin < work.triangles.size();) {  // patch after patch
    const Index patch = work.triangle_patch[begin];
    std::size_t end = begin;
    while (end < work.triangles.size() && work.triangle_patch[end] == patch) ++end;
    const auto at = [&](std::size_t t) { return from + static_cast<std::ptrdiff_t>(t); };
    std::vector<Triangle> part(at(begin), at(end));
    turned[patch] = orient_mesh(work.vertices, part, normals, work.options.mesh.up);
    std::copy(part.begin(), part.end(), at(begin));
    begin = end;
  }
  mirror(work, turned);
  pack_patches(work.patch, count, work.uv);  // those mirrored about the axis may have come over others
}

}  // namespace rimline::pipeline
