// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/filled_holes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "rimline/loops.h"

namespace rimline::pipeline {
namespace {

// Edges of rims. Where two holes touched, one rim has the edges of both loops.
using RimEdges = std::set<std::pair<Index, Index>>;

std::pair<Index, Index> edge_at(const std::vector<Index>& loop, std::size_t i) {
  return std::minmax(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
}

bool has_all(const RimEdges& edges, const std::vector<Index>& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (!edges.contains(edge_at(loop, i))) return false;
  }
  return true;
}

// Points of loops that are gone, and of none that stays.
void relabel(Work& work, const std::vector<Loop>& gone) {
  if (work.label.empty()) return;
  for (const Loop& loop : gone) {
    for (const Index v : loop.points) work.label[v] = PointLabel::Undersampled;
  }
  for (const Loop& loop : work.loops) {
    for (const Index v : loop.points) work.label[v] = PointLabel::Boundary;
  }
}

}  // namespace

void take_out_filled(Work& work, const std::vector<PatchReport>& patches) {
  HoleSummary summary;
  RimEdges filled;
  for (const PatchReport& patch : patches) {
    for (const HoleFill& fill : patch.fills) {
      if (fill.triangles == 0) {
        ++summary.failed;
        continue;
      }
      for (std::size_t i = 0; i < fill.rim.size(); ++i) filled.insert(edge_at(fill.rim, i));
      summary.filled.push_back({fill.rim.size(), loop_length(work.arrangement.points, fill.rim),
                                fill.triangles, fill.added_points});
    }
  }
  const auto stays = [&](const Loop& loop) {
    return loop.kind == LoopKind::Outer || !has_all(filled, loop.points);
  };
  const auto gone = std::stable_partition(work.loops.begin(), work.loops.end(), stays);
  const std::vector<Loop> taken(gone, work.loops.end());
  work.loops.erase(gone, work.loops.end());
  relabel(work, taken);
  summary.kept = std::count_if(work.loops.begin(), work.loops.end(),
                               [](const Loop& loop) { return loop.kind == LoopKind::Hole; });
  summary.found = summary.kept + summary.filled.size();
  if (summary.failed > 0) {
    work.report.warnings.push_back(
        fmt::format("{} holes stay open: they touch another hole in a point, or every triangulation of their "
                    "rims would make an edge that the mesh has already",
                    summary.failed));
  }
  work.report.holes = std::move(summary);
}

}  // namespace rimline::pipeline
