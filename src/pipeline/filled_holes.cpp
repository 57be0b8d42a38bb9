// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/filled_holes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/vec.h"
#include "rimline/find_genetic_loop.h"

namespace rimline::pipeline {
namespace {

using RimEdges = std::set<std::pair<Index, Index>>;

std::pair<Index, Index> edge_at(const std::vector<Index>& loop, std::size_t i) {
  return std::minmax(loop[i], loop[next_in(i, loop.size())]);
}

bool has_all(const RimEdges& edges, const std::vector<Index>& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (!edges.contains(edge_at(loop, i))) return false;
  }
  return true;
}

// The rims that were filled; where two holes touched, one rim has the edges of both loops.
RimEdges filled_edges(const std::vector<PatchReport>& patches) {
  RimEdges filled;
  for (const PatchReport& patch : patches) {
    for (const HoleFill& fill : patch.fills) {
      if (fill.triangles == 0) continue;
      for (std::size_t i = 0; i < fill.rim.size(); ++i) filled.insert(edge_at(fill.rim, i));
    }
  }
  return filled;
}

// Points of removed loops that are on no remaining one.
std::vector<PointLabel> relabel(std::vector<PointLabel> label, const std::vector<Loop>& gone,
                                const std::vector<Loop>& stay) {
  if (label.empty()) return label;
  for (const Loop& loop : gone) {
    for (const Index v : loop.points) label[v] = PointLabel::Undersampled;
  }
  for (const Loop& loop : stay) {
    for (const Index v : loop.points) label[v] = PointLabel::Boundary;
  }
  return label;
}

HoleSummary summarize_holes(const MappedMesh& mesh, const std::vector<PatchReport>& patches) {
  HoleSummary summary;
  for (const PatchReport& patch : patches) {
    for (const HoleFill& fill : patch.fills) {
      if (fill.triangles == 0) {
        ++summary.failed;
        continue;
      }
      summary.filled.push_back(
          {fill.rim.size(), loop_length(mesh.vertices, fill.rim), fill.triangles, fill.added_points});
    }
  }
  summary.kept = std::count_if(mesh.loops.begin(), mesh.loops.end(),
                               [](const Loop& loop) { return loop.kind == LoopKind::Hole; });
  summary.found = summary.kept + summary.filled.size();
  return summary;
}

}  // namespace

MappedMesh take_out_filled(MappedMesh mesh, const std::vector<PatchReport>& patches) {
  const RimEdges filled = filled_edges(patches);
  const auto gone = std::stable_partition(mesh.loops.begin(), mesh.loops.end(), [&](const Loop& loop) {
    return loop.kind == LoopKind::Outer || !has_all(filled, loop.points);
  });
  const std::vector<Loop> taken(gone, mesh.loops.end());
  mesh.loops.erase(gone, mesh.loops.end());
  mesh.label = relabel(std::move(mesh.label), taken, mesh.loops);
  mesh.holes = summarize_holes(mesh, patches);
  if (mesh.holes->failed > 0) {
    mesh.warnings.push_back(fmt::format(
        "{} holes stay open: every triangulation of their rims would make an edge that the mesh has "
        "already",
        mesh.holes->failed));
  }
  return mesh;
}

}  // namespace rimline::pipeline
