// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/final_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/vec.h"
#include "mesh/manifold.h"
#include "pipeline/left_out.h"

namespace rimline::pipeline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

MappedMesh without_turned_maps(MappedMesh mesh) {
  std::vector<char> turned(mesh.components.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Index c = mesh.triangle_patch[t];
    if (has_map(mesh.components[c].map) && !(twice_area(mesh.uv, mesh.triangles[t]) > 0)) turned[c] = 1;
  }
  const auto count = std::ranges::count(turned, 1);
  if (count == 0) return mesh;
  for (std::size_t v = 0; v < mesh.uv.size(); ++v) {
    if (mesh.patch[v] != none && turned[mesh.patch[v]]) mesh.uv[v] = {nan, nan};
  }
  for (std::size_t c = 0; c < turned.size(); ++c) {
    if (turned[c]) mesh.components[c].map = Domain::None;
  }
  mesh.warnings.push_back(fmt::format(
      "the domain's maps of {} components are left out: they have triangles without area in double precision",
      count));
  return mesh;
}

std::vector<Loop> loops_of(const MappedMesh& mesh, Index component) {
  std::vector<Loop> loops;
  for (const Loop& loop : mesh.loops) {
    if (mesh.patch[loop.points.front()] == component) loops.push_back(loop);
  }
  return loops;
}

std::string fault_of_component(const MappedMesh& mesh, Index component, const Run& run) {
  std::vector<Triangle> own;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangle_patch[t] == component) own.push_back(mesh.triangles[t]);
  }
  if (own.empty()) return "";
  const auto is_foreign = [&](Index v) { return mesh.patch[v] != component; };
  if (std::ranges::any_of(own, [&](const Triangle& t) { return std::ranges::any_of(t, is_foreign); }))
    return "it shares a point with another component";
  return fault_of(own, mesh.vertices.size(), loops_of(mesh, component), mesh.components[component].orientable,
                  run);
}

// The list with an entry for the component, by its size.
std::vector<LeftOut> listed(const MappedMesh& mesh, Index component, const std::string& fault,
                            const PreparedPoints& prepared) {
  std::vector<Index> points;
  for (Index v = 0; v < static_cast<Index>(prepared.points().size()); ++v) {
    if (mesh.patch[v] == component) points.push_back(v);
  }
  std::vector<LeftOut> all = mesh.left_out;
  if (points.empty()) return all;
  LeftOut part = points_left_out(prepared, points);
  part.component = component;
  part.cause = fault;
  part.remedy = remedy_of_component;
  const auto at =
      std::ranges::find_if(all, [&](const LeftOut& other) { return other.ids.size() < part.ids.size(); });
  all.insert(at, std::move(part));
  return all;
}

MappedMesh without_component(MappedMesh mesh, Index component, const std::string& fault) {
  std::erase_if(mesh.loops, [&](const Loop& loop) { return mesh.patch[loop.points.front()] == component; });
  std::vector<Triangle> triangles;
  std::vector<Index> owner;
  std::vector<char> filled;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangle_patch[t] == component) continue;
    triangles.push_back(mesh.triangles[t]);
    owner.push_back(mesh.triangle_patch[t]);
    filled.push_back(mesh.filled[t]);
  }
  mesh.triangles = std::move(triangles);
  mesh.triangle_patch = std::move(owner);
  mesh.filled = std::move(filled);
  for (std::size_t v = 0; v < mesh.patch.size(); ++v) {
    if (mesh.patch[v] != component) continue;
    mesh.patch[v] = none;
    mesh.uv[v] = {nan, nan};
  }
  ComponentSummary& summary = mesh.components[component];
  summary.triangles = 0;
  summary.map = Domain::None;
  summary.failure = fault;
  mesh.warnings.push_back(fmt::format("component {} is left out: {}", component, fault));
  return mesh;
}

}  // namespace

MappedMesh checked(MappedMesh mesh, const PreparedPoints& prepared, const Run& run) {
  mesh = without_turned_maps(std::move(mesh));
  const bool orientable = std::ranges::all_of(mesh.components, &ComponentSummary::orientable);
  if (mesh.triangles.empty() ||
      fault_of(mesh.triangles, mesh.vertices.size(), mesh.loops, orientable, run).empty())
    return mesh;
  for (std::size_t c = 0; c < mesh.components.size(); ++c) {
    const std::string fault = fault_of_component(mesh, static_cast<Index>(c), run);
    if (fault.empty()) continue;
    mesh.left_out = listed(mesh, static_cast<Index>(c), fault, prepared);
    mesh = without_component(std::move(mesh), static_cast<Index>(c), fault);
  }
  return mesh;
}

}  // namespace rimline::pipeline
