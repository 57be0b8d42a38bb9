// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/orientation.h"

#include <algorithm>
#include <limits>

#include "base/domain_traits.h"
#include "mesh/enclosure.h"
#include "patch/pack.h"
#include "rimline/delaunay.h"

namespace rimline::pipeline {
namespace {

// The height about which a map is mirrored: the axis, where only signs change, or the middle of a box that
// stands on the axis.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

std::vector<Range> heights_of(const MappedMesh& mesh, std::size_t patches, Domain domain) {
  if (traits(domain).outline != Outline::Box) return std::vector<Range>(patches, Range{0, 0});
  std::vector<Range> ranges(patches);
  for (std::size_t i = 0; i < mesh.uv.size(); ++i) {
    if (mesh.patch[i] == none) continue;
    Range& range = ranges[mesh.patch[i]];
    range.low = std::min(range.low, mesh.uv[i].v);
    range.high = std::max(range.high, mesh.uv[i].v);
  }
  return ranges;
}

// Mirrors the map of a patch that was turned: triangles stay counter-clockwise in uv, and loops keep the
// surface on their left.
MappedMesh mirror(MappedMesh mesh, const std::vector<char>& turned, Domain domain) {
  const bool whole = mesh.patch.empty();
  const auto is_turned = [&](Index v) {
    if (whole) return turned[0] != 0;
    return mesh.patch[v] != none && turned[mesh.patch[v]] != 0;
  };
  const std::vector<Range> heights = heights_of(mesh, turned.size(), domain);
  for (Index i = 0; i < static_cast<Index>(mesh.uv.size()); ++i) {
    if (!is_turned(i)) continue;
    const Range& range = heights[whole ? 0 : mesh.patch[i]];
    mesh.uv[i].v = range.low + range.high - mesh.uv[i].v;
  }
  for (Loop& loop : mesh.loops) {
    if (is_turned(loop.points.front())) std::reverse(loop.points.begin() + 1, loop.points.end());
  }
  return mesh;
}

}  // namespace

std::vector<Point> arranged_normals(const Given& given, const PreparedPoints& prepared) {
  std::vector<Point> normals;
  if (given.normals.empty()) return normals;
  for (const Index id : prepared.ids()) normals.push_back(given.normals[id]);
  return normals;
}

MappedMesh orient_whole(MappedMesh mesh, std::vector<Point> normals, Point up) {
  if (!orient_mesh(mesh.vertices, mesh.triangles, normals, up)) return mesh;
  return mirror(std::move(mesh), {1}, Domain::Disc);
}

namespace {

// Turns the triangles of one patch by the input's normals, else outward where it encloses a volume, else up.
// Returns whether they were turned.
bool orient_patch(const MappedMesh& mesh, Index patch, std::span<const Point> normals, Point up,
                  std::vector<Triangle>& triangles) {
  if (normals.empty()) {
    std::vector<Loop> loops;
    for (const Loop& loop : mesh.loops) {
      if (mesh.patch[loop.points.front()] == patch) loops.push_back(loop);
    }
    const Side side = faced_side(mesh.vertices, triangles, loops);
    if (side == Side::Outward) return false;
    if (side == Side::Inward) {
      for (Triangle& t : triangles) std::swap(t[1], t[2]);
      return true;
    }
  }
  return orient_mesh(mesh.vertices, triangles, normals, up);
}

}  // namespace

MappedMesh orient_patches(MappedMesh mesh, std::vector<Point> normals, Point up, Domain domain) {
  if (!normals.empty()) normals.resize(mesh.vertices.size());  // vertices of fills have none of their own
  std::vector<char> turned(mesh.components.size(), 0);
  const auto at = [&](std::size_t t) { return mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t); };
  for (std::size_t begin = 0; begin < mesh.triangles.size();) {  // patch after patch
    const Index patch = mesh.triangle_patch[begin];
    std::size_t end = begin;
    while (end < mesh.triangles.size() && mesh.triangle_patch[end] == patch) ++end;
    std::vector<Triangle> part(at(begin), at(end));
    turned[patch] = mesh.components[patch].orientable && orient_patch(mesh, patch, normals, up, part);
    std::copy(part.begin(), part.end(), at(begin));
    begin = end;
  }
  const std::size_t patches = turned.size();
  mesh = mirror(std::move(mesh), turned, domain);
  pack_patches(mesh.patch, patches, mesh.uv);  // patches mirrored about the axis may overlap others
  return mesh;
}

}  // namespace rimline::pipeline
