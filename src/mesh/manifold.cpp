// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/manifold.h"

#include <array>

#include "base/parallel.h"
#include "mesh/corners.h"

namespace rimline {
namespace {

enum class Fault { None, Twice, Crowded, Turned, Split, OffLoops };

const char* words(Fault fault) {
  switch (fault) {
    case Fault::None: return "";
    case Fault::Twice: return "a triangle is there twice";
    case Fault::Crowded: return "an edge has more than two triangles";
    case Fault::Turned: return "neighbours do not face the same way";
    case Fault::Split: return "the triangles of a vertex form more than one fan";
    case Fault::OffLoops: return "the boundary is not the loops";
  }
  return "";
}

bool has_sound_corners(std::span<const Triangle> triangles, std::size_t vertices) {
  return std::ranges::all_of(triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t,
                               [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < vertices; }) &&
           t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  });
}

// The points before and after each on its loop; a point on two loops has neighbours of the last, and the edge
// of the other is missed.
struct LoopEdges {
  std::vector<std::array<Index, 2>> beside;

  LoopEdges(const std::vector<Loop>& loops, std::size_t vertices) : beside(vertices, {none, none}) {
    for (const Loop& loop : loops) {
      const std::size_t n = loop.points.size();
      for (std::size_t i = 0; i < n; ++i)
        beside[loop.points[i]] = {loop.points[(i + n - 1) % n], loop.points[(i + 1) % n]};
    }
  }
  bool has(Index a, Index b) const { return beside[a][0] == b || beside[a][1] == b; }
};

// Whether two triangles at a vertex run along one of its edges in the same direction.
bool runs_alike(std::span<const Corners::Corner> corners, std::vector<Index>& next) {
  next.clear();
  for (const Corners::Corner& c : corners) next.push_back(c.next);
  std::ranges::sort(next);
  return std::ranges::adjacent_find(next) != next.end();
}

// Work space of one thread.
struct Look {
  Vertex vertex;
  std::vector<Index> next;
};

Fault fault_at(Index v, std::span<const Corners::Corner> corners, const LoopEdges& loops, bool orientable,
               Look& look) {
  bool crowded = false, off_loops = false;
  std::size_t open = 0;
  const std::size_t fans = look.vertex.visit(corners, [&](Index other, std::size_t triangles) {
    crowded = crowded || triangles > 2;
    if (triangles > 1) return;
    ++open;
    off_loops = off_loops || !loops.has(v, other);
  });
  if (crowded) return Fault::Crowded;
  // Around a vertex of two triangles of the same corners no edge is open.
  if (open == 0 && corners.size() == 2) return Fault::Twice;
  if (fans > 1) return Fault::Split;
  if (orientable && runs_alike(corners, look.next)) return Fault::Turned;
  if (off_loops || (open == 0 && loops.beside[v][0] != none)) return Fault::OffLoops;
  return Fault::None;
}

}  // namespace

std::string fault_of(std::span<const Triangle> triangles, std::size_t vertices,
                     const std::vector<Loop>& loops, bool orientable, const Run& run) {
  if (triangles.empty()) return "there is no triangle";
  if (!has_sound_corners(triangles, vertices)) return "a corner is repeated or no vertex";
  const Corners corners(triangles, vertices);
  const LoopEdges edges(loops, vertices);
  constexpr std::size_t slice = 8192;
  std::vector<Fault> found((vertices + slice - 1) / slice, Fault::None);
  parallel_tasks(found.size(), Stage::Refine, run.without_progress(), [&](std::size_t k) {
    Look look;
    for (std::size_t v = k * slice; v < std::min(vertices, (k + 1) * slice); ++v) {
      const auto own = corners.of(static_cast<Index>(v));
      if (own.empty() || (found[k] != Fault::None && found[k] != Fault::OffLoops)) continue;
      const Fault fault = fault_at(static_cast<Index>(v), own, edges, orientable, look);
      if (fault != Fault::None) found[k] = fault;
    }
  });
  run.check_cancel();
  const auto unused = [&](const Loop& loop) {
    return std::ranges::any_of(loop.points, [&](Index v) { return corners.of(v).empty(); });
  };
  const bool off_loops = std::ranges::count(found, Fault::OffLoops) > 0 || std::ranges::any_of(loops, unused);
  const auto worse = [](Fault fault) { return fault != Fault::None && fault != Fault::OffLoops; };
  const auto first = std::ranges::find_if(found, worse);
  return words(first != found.end() ? *first : off_loops ? Fault::OffLoops : Fault::None);
}

}  // namespace rimline
