// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/join_components.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "patch/pack.h"

namespace rimline {
namespace {

constexpr UV no_uv{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

PatchReport report_on(const Component& component, const RefineOptions& options) {
  const Patch& patch = component.patch;
  PatchReport report;
  report.points = component.points.size();
  report.triangles = patch.triangles.size();
  report.loops = component.loops.size();
  report.rounds = patch.rounds;
  report.map = patch.map;
  report.uv_flips = patch.uv_flips;
  report.evened = patch.evened;
  report.domain = patch.domain;
  report.orientable = component.orientable;
  report.genus = component.genus;
  report.repairs = component.repairs;
  report.failure = component.failure;
  if (!component.failure.empty()) {
    report.domain = Domain::None;
    report.ids = component.points;
    return report;
  }
  report.fills = patch.fills;
  for (HoleFill& fill : report.fills) {
    for (Index& v : fill.rim) v = component.points[v];
  }
  std::size_t rim = 0, bad = std::numeric_limits<std::size_t>::max();
  for (const Loop& loop : component.loops) rim += loop.points.size();
  for (const RefineRound& round : patch.rounds) bad = std::min(bad, round.bad_edges);
  const double inner = (3.0 * static_cast<double>(patch.triangles.size()) - static_cast<double>(rim)) / 2;
  report.bad_share = inner > 0 ? static_cast<double>(bad) / inner : 0;
  report.suspect = report.bad_share > options.suspect_share;
  return report;
}

void append_loops(const Component& component, Surface& surface) {
  for (Loop loop : component.loops) {
    for (Index& v : loop.points) v = component.points[v];
    loop.component = static_cast<Index>(surface.patches.size()) - 1;
    surface.loops.push_back(std::move(loop));
  }
}

// Appends the mesh of the component reported last.
void append(const Component& component, Surface& surface) {
  const Patch& patch = component.patch;
  const Index at = static_cast<Index>(surface.patches.size()) - 1;
  const auto own = static_cast<Index>(component.points.size());
  const auto first_added = static_cast<Index>(surface.uv.size());
  const auto whole = [&](Index v) { return v < own ? component.points[v] : first_added + (v - own); };
  for (const Triangle& t : patch.triangles) {
    surface.triangles.push_back({whole(t[0]), whole(t[1]), whole(t[2])});
  }
  for (Index i = 0; i < own; ++i) {
    surface.uv[component.points[i]] = patch.uv[i];
    surface.patch[component.points[i]] = at;
  }
  surface.added.insert(surface.added.end(), patch.added.begin(), patch.added.end());
  surface.uv.insert(surface.uv.end(), patch.uv.begin() + own, patch.uv.end());
  surface.patch.insert(surface.patch.end(), patch.added.size(), at);
  surface.triangle_patch.resize(surface.triangles.size(), at);
  std::size_t filled = 0;
  for (const HoleFill& fill : patch.fills) filled += fill.triangles;
  surface.filled.resize(surface.triangles.size() - filled, 0);
  surface.filled.resize(surface.triangles.size(), 1);
  append_loops(component, surface);
}

void drop_turned_map(Patch& patch) {
  if (patch.uv_flips == 0) return;
  std::ranges::fill(patch.uv, no_uv);
  patch.domain = Domain::None;
}

}  // namespace

Surface join_components(std::size_t points, std::vector<Component> components, const RefineOptions& options) {
  Surface surface;
  surface.uv.assign(points, no_uv);
  surface.patch.assign(points, none);
  for (Component& component : components) {
    drop_turned_map(component.patch);
    surface.patches.push_back(report_on(component, options));
    if (component.failure.empty()) append(component, surface);
    component.patch = {};
  }
  for (Index v = 0; v < static_cast<Index>(points); ++v) {
    if (surface.patch[v] == none) surface.left_out.push_back(v);
  }
  pack_patches(surface.patch, surface.patches.size(), surface.uv);
  return surface;
}

}  // namespace rimline
