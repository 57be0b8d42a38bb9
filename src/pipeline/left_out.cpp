// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/left_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "base/union_find.h"

namespace rimline::pipeline {
namespace {

// Groups of the points given, by their nearest neighbours.
std::vector<std::vector<Index>> groups_of(const Neighbours& neighbours, const std::vector<Index>& points) {
  constexpr int near = 6;
  UnionFind joined(points.size());
  const auto place = [&](Index v) -> Index {
    const auto at = std::ranges::lower_bound(points, v);
    return at == points.end() || *at != v ? none : static_cast<Index>(at - points.begin());
  };
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    for (const Index other : neighbours.of(points[i], std::min(near, neighbours.k))) {
      const Index j = place(other);
      if (j != none) joined.join(i, j);
    }
  }
  std::map<Index, std::vector<Index>> groups;
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) groups[joined.find(i)].push_back(points[i]);
  std::vector<std::vector<Index>> result;
  for (auto& [root, group] : groups) result.push_back(std::move(group));
  return result;
}

}  // namespace

LeftOut points_left_out(const PreparedPoints& prepared, const std::vector<Index>& points) {
  LeftOut part;
  part.low = part.high = prepared.input[prepared.ids()[points.front()]];
  for (const Index v : points) {
    const Index id = prepared.ids()[v];
    const Point p = prepared.input[id];
    part.ids.push_back(id);
    part.low = {std::min(part.low.x, p.x), std::min(part.low.y, p.y), std::min(part.low.z, p.z)};
    part.high = {std::max(part.high.x, p.x), std::max(part.high.y, p.y), std::max(part.high.z, p.z)};
  }
  std::ranges::sort(part.ids);
  return part;
}

std::vector<LeftOut> describe_left_out(const PreparedPoints& prepared, const Surface& surface) {
  std::vector<LeftOut> parts;
  std::vector<char> told(prepared.points().size(), 0);
  for (std::size_t p = 0; p < surface.patches.size(); ++p) {
    const PatchReport& patch = surface.patches[p];
    if (patch.failure.empty()) continue;
    for (const Index v : patch.ids) told[v] = 1;
    LeftOut& part = parts.emplace_back(points_left_out(prepared, patch.ids));
    part.component = static_cast<Index>(p);
    part.cause = patch.failure;
    part.remedy = remedy_of_component;
  }
  std::vector<Index> loose;
  std::ranges::copy_if(surface.left_out, std::back_inserter(loose), [&](Index v) { return !told[v]; });
  for (const std::vector<Index>& group : groups_of(prepared.neighbours, loose)) {
    LeftOut& part = parts.emplace_back(points_left_out(prepared, group));
    part.cause = "no triangle of the surface is within reach: the points lie off it, or are a scrap";
    part.remedy = "leave the points out, or sample the place more densely";
  }
  std::ranges::stable_sort(parts,
                           [](const LeftOut& a, const LeftOut& b) { return a.ids.size() > b.ids.size(); });
  return parts;
}

std::optional<Error> why_no_mesh(const MappedMesh& mesh, bool strict) {
  if (mesh.triangles.empty()) {
    return Error(ErrorCode::NoClosedLoop,
                 "no triangle can be given: the points lie on no surface that their neighbourhoods tell");
  }
  if (!strict || mesh.left_out.empty()) return {};
  const std::size_t missing = mesh.left_out.size();
  const LeftOut& first =
      *std::ranges::max_element(mesh.left_out, {}, [](const LeftOut& part) { return part.ids.size(); });
  return Error(ErrorCode::NotADisc,
               fmt::format("{} {} not in the mesh, and strict asks for all; the largest: {}", missing,
                           missing == 1 ? "part is" : "parts are", first.cause),
               first.ids);
}

}  // namespace rimline::pipeline
