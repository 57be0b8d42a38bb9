// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/mend_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/editable_mesh.h"
#include "mesh/orient.h"
#include "patch/close_gap.h"
#include "patch/handles.h"
#include "patch/insert_near.h"
#include "patch/loops_of_mesh.h"
#include "patch/single_fans.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {
namespace {

constexpr std::size_t scrap = 10;  // triangles: components with fewer are dropped beside larger ones

std::vector<std::size_t> sizes_of(const std::vector<Index>& component) {
  std::vector<std::size_t> sizes;
  for (const Index c : component) {
    if (c == none) continue;
    if (static_cast<std::size_t>(c) >= sizes.size()) sizes.resize(c + 1, 0);
    ++sizes[c];
  }
  return sizes;
}

void drop_scraps(EditableMesh& mesh) {
  const std::vector<Index> component = mesh.components();
  const std::vector<std::size_t> sizes = sizes_of(component);
  if (sizes.empty()) return;
  const std::size_t least = std::min(scrap, *std::ranges::max_element(sizes));
  for (Index t = 0; t < static_cast<Index>(component.size()); ++t) {
    if (component[t] != none && sizes[component[t]] < least) mesh.remove(t);
  }
}

// Rims of one component.
struct PartRims {
  std::size_t triangles = 0, vertices = 0;
  std::vector<std::size_t> rims;
};

std::vector<PartRims> part_rims(const EditableMesh& mesh, const std::vector<MatchedRim>& rims) {
  const std::vector<Index> component = mesh.components();
  std::vector<PartRims> parts;
  const std::vector<std::size_t> sizes = sizes_of(component);
  parts.resize(sizes.size());
  for (std::size_t c = 0; c < sizes.size(); ++c) parts[c].triangles = sizes[c];
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (!mesh.star(v).empty()) ++parts[component[mesh.star(v).front()]].vertices;
  }
  for (std::size_t r = 0; r < rims.size(); ++r)
    parts[component[mesh.star(rims[r].points.front()).front()]].rims.push_back(r);
  return parts;
}

// A component without a loop is closed except for gaps, or ends at its longest rim: the rim of an open sheet
// of V points has at least 3.5 sqrt(V) of them, and up to half as many are taken for a gap.
void settle_boundary(const EditableMesh& mesh, const PartRims& part, std::vector<MatchedRim>& rims) {
  constexpr double open = 1.75;
  if (part.rims.empty() || std::ranges::any_of(part.rims, [&](std::size_t r) { return rims[r].is_open; }))
    return;
  const auto length = [&](std::size_t r) { return loop_length(mesh.points(), rims[r].points); };
  const std::size_t longest = *std::ranges::max_element(
      part.rims, [&](std::size_t a, std::size_t b) { return length(a) < length(b); });
  rims[longest].is_open = static_cast<double>(rims[longest].points.size()) >=
                          open * std::sqrt(static_cast<double>(part.vertices));
}

std::vector<MatchedRim> close_gaps(EditableMesh& mesh, const std::vector<Loop>& loops) {
  std::vector<MatchedRim> rims = match_rims(walk_rims(mesh), loops, mesh.points().size());
  for (const PartRims& part : part_rims(mesh, rims)) settle_boundary(mesh, part, rims);
  for (MatchedRim& rim : rims) {
    if (!rim.is_open) rim.is_open = !close_gap(mesh, rim.points);
  }
  std::erase_if(rims, [](const MatchedRim& rim) { return !rim.is_open; });
  return rims;
}

// The loop of a rim, with the properties of the loop found along it.
Loop loop_of(const EditableMesh& mesh, MatchedRim rim, const std::vector<Loop>& loops) {
  Loop loop;
  loop.kind = LoopKind::Hole;
  if (rim.loop != none) loop = loops[rim.loop];
  loop.points = std::move(rim.points);
  loop.length = loop_length(mesh.points(), loop.points);
  return loop;
}

// One outer loop, the first: the one found as outer, or the longest.
void put_outer_first(std::vector<Loop>& loops) {
  if (loops.empty()) return;
  const auto outer = std::ranges::max_element(loops, [](const Loop& a, const Loop& b) {
    return std::pair(a.kind == LoopKind::Outer, a.length) < std::pair(b.kind == LoopKind::Outer, b.length);
  });
  std::rotate(loops.begin(), outer, outer + 1);
  for (Loop& loop : loops) loop.kind = LoopKind::Hole;
  loops.front().kind = LoopKind::Outer;
}

// 2 - V + E - F - loops: twice the handles of a surface, or the cross-caps of a one-sided one.
long long missing_euler(const MendedPart& part, std::size_t vertices) {
  std::size_t rim = 0;
  for (const Loop& loop : part.loops) rim += loop.points.size();
  const auto edges = static_cast<long long>((3 * part.triangles.size() + rim) / 2);
  return 2 - static_cast<long long>(vertices) + edges - static_cast<long long>(part.triangles.size()) -
         static_cast<long long>(part.loops.size());
}

// A point in a triangle at the curve of a repair, or near it; none where there is none.
Index beside(const EditableMesh& mesh, const Neighbours& neighbours, const HandleRepair& repair) {
  const auto used = [&](Index v) { return !mesh.star(v).empty(); };
  const auto on = std::ranges::find_if(repair.points, used);
  if (on != repair.points.end()) return *on;
  for (const Index v : repair.points) {
    const auto near = neighbours.of(v);
    const auto at = std::ranges::find_if(near, used);
    if (at != near.end()) return *at;
  }
  return none;
}

std::vector<MendedPart> take_parts(const EditableMesh& mesh, std::vector<MatchedRim> rims,
                                   const MendInput& input, const std::vector<HandleRepair>& repairs) {
  const std::vector<Index> component = mesh.components();
  const std::vector<PartRims> counts = part_rims(mesh, rims);
  std::vector<MendedPart> parts(counts.size());
  for (Index t = 0; t < mesh.places(); ++t) {
    if (mesh.has(t)) parts[component[t]].triangles.push_back(mesh.triangle(t));
  }
  for (const HandleRepair& repair : repairs) {
    const Index at = beside(mesh, input.neighbours, repair);
    if (at != none) parts[component[mesh.star(at).front()]].repairs.push_back(repair);
  }
  for (std::size_t c = 0; c < parts.size(); ++c) {
    MendedPart& part = parts[c];
    for (const std::size_t r : counts[c].rims)
      part.loops.push_back(loop_of(mesh, std::move(rims[r]), input.loops));
    put_outer_first(part.loops);
    part.orientable = orient_alike(part.triangles);
    const long long missing = missing_euler(part, counts[c].vertices);
    part.genus = static_cast<int>(part.orientable ? missing / 2 : missing);
    turn_loops_along(part.triangles, part.loops);
  }
  return parts;
}

}  // namespace

std::vector<MendedPart> mend_surface(const MendInput& input, HandlePolicy handles, const Run& run) {
  std::vector<Triangle> triangles(input.triangles.begin(), input.triangles.end());
  orient_alike(triangles);
  EditableMesh mesh(input.points, triangles);
  leave_single_fans(mesh, input.spacing);
  run.check_cancel();
  drop_scraps(mesh);
  std::vector<MatchedRim> rims = close_gaps(mesh, input.loops);
  run.check_cancel();
  std::vector<HandleRepair> repairs;
  if (handles == HandlePolicy::Repair) repairs = repair_handles(mesh, run);
  if (!repairs.empty()) rims = match_rims(walk_rims(mesh), input.loops, input.points.size());
  run.check_cancel();
  insert_near(mesh, input.neighbours, input.spacing);
  return take_parts(mesh, std::move(rims), input, repairs);
}

}  // namespace rimline
