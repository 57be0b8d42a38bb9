// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/orientation.h"

#include <algorithm>

#include "rimline/triangulate.h"

namespace rimline::pipeline {
namespace {

std::vector<Point> arranged_normals(const Work& work) {
  std::vector<Point> normals;
  if (work.given.normals.empty()) return normals;
  for (const Index id : work.arrangement.ids) normals.push_back(work.given.normals[id]);
  return normals;
}

// Seen from the side it faces, the map of a patch that was turned round is mirrored too: triangles stay
// counter-clockwise in uv, and loops keep the surface on their left.
template <class Turned>
void mirror(Work& work, const Turned& turned) {
  // About the axis of the disc, or about the middle of a box that stands on the axis.
  const bool box = work.options.map.domain == Domain::Square || work.options.map.domain == Domain::Rectangle;
  const Index n = static_cast<Index>(work.uv.size());
  double low = 0, high = 0;
  for (Index i = 0; box && i < n; ++i) {
    if (!turned(i)) continue;
    low = std::min(low, work.uv[i].v);
    high = std::max(high, work.uv[i].v);
  }
  for (Index i = 0; i < n; ++i) {
    if (turned(i)) work.uv[i].v = low + high - work.uv[i].v;
  }
  for (Loop& loop : work.loops) {
    if (turned(loop.points.front())) std::reverse(loop.points.begin() + 1, loop.points.end());
  }
}

// A point in which two patches touch counts to one of them; the triangle's other corners decide.
Index patch_of(const Work& work, const Triangle& t) {
  return work.patch[t[1]] == work.patch[t[2]] ? work.patch[t[1]] : work.patch[t[0]];
}

}  // namespace

void orient_whole(Work& work) {
  const std::vector<Point> normals = arranged_normals(work);
  if (orient_mesh(work.arrangement.points, work.triangles, normals, work.options.mesh.up)) {
    mirror(work, [](Index) { return true; });
  }
}

void orient_patches(Work& work, std::size_t count) {
  const std::vector<Point> normals = arranged_normals(work);
  std::vector<std::vector<Triangle>> parts(count);
  for (const Triangle& t : work.triangles) parts[patch_of(work, t)].push_back(t);
  std::vector<char> turned(count, 0);
  work.triangles.clear();
  for (std::size_t i = 0; i < count; ++i) {
    turned[i] = orient_mesh(work.arrangement.points, parts[i], normals, work.options.mesh.up);
    work.triangles.insert(work.triangles.end(), parts[i].begin(), parts[i].end());
  }
  mirror(work, [&](Index point) { return work.patch[point] != none && turned[work.patch[point]]; });
}

}  // namespace rimline::pipeline
