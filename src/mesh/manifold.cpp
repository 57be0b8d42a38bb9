// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/manifold.h"

#include <array>

#include "base/parallel.h"
#include "mesh/corners.h"

namespace rimline {
namespace {

using Corner = Corners::Corner;

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
bool runs_alike(std::span<const Corner> corners, std::vector<Index>& next) {
  next.clear();
  for (const Corner& c : corners) next.push_back(c.next);
  std::ranges::sort(next);
  return std::ranges::adjacent_find(next) != next.end();
}

// Goes from corner to corner, entering each at one of its edges and leaving it at the other, until no corner
// goes on or the edge `stop` is reached. `at`: the edge where it starts, then where it ends. Returns the
// steps. Requires that no two corners are entered at the same edge.
std::size_t walk(std::span<const Corner> corners, Index Corner::*enter, Index Corner::*leave, Index& at,
                 Index stop) {
  std::size_t steps = 0;
  while (at != stop) {
    const auto on = std::ranges::find(corners, at, enter);
    if (on == corners.end()) break;
    at = (*on).*leave;
    ++steps;
  }
  return steps;
}

// Whether the corners of a vertex are one fan of triangles that face alike, closed or from one edge of its
// loop to the other: what nearly every vertex is. A no does not say what is wrong, or whether anything is.
bool is_plain_fan(Index v, std::span<const Corner> corners, const LoopEdges& loops) {
  constexpr std::size_t most = 16;  // [speed]
  const std::size_t n = corners.size();
  if (n > most) return false;
  // No edge is left or met twice: the corners form chains and rings.
  bool twice = false;
  for (std::size_t i = 1; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      twice |= corners[i].next == corners[j].next || corners[i].previous == corners[j].previous;
  }
  if (twice) return false;
  Index begin = corners[0].next, end = corners[0].previous;
  std::size_t passed = 1 + walk(corners, &Corner::next, &Corner::previous, end, begin);
  if (end == begin) return passed == n && n > 2 && loops.beside[v][0] == none;
  passed += walk(corners, &Corner::previous, &Corner::next, begin, end);
  return passed == n && loops.has(v, begin) && loops.has(v, end);
}

// Work space of one thread.
struct Look {
  Vertex vertex;
  std::vector<Index> next;
};

Fault fault_at(Index v, std::span<const Corner> corners, const LoopEdges& loops, bool orientable,
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
      if (is_plain_fan(static_cast<Index>(v), own, edges)) continue;
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
