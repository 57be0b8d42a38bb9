// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/pinches.h"

#include <utility>

#include "base/vec.h"

namespace rimline {
namespace {

// One visit of a loop to a point.
struct Pass {
  Index point, loop, next;  // next: the following visit
};

std::vector<Pass> passes_of(const std::vector<Loop>& loops) {
  std::vector<Pass> passes;
  for (Index l = 0; l < static_cast<Index>(loops.size()); ++l) {
    const Index first = static_cast<Index>(passes.size()), count = static_cast<Index>(loops[l].points.size());
    for (Index i = 0; i < count; ++i) passes.push_back({loops[l].points[i], l, first + next_in(i, count)});
  }
  return passes;
}

}  // namespace

Separated separate_pinches(const std::vector<Loop>& loops, Index point_count) {
  Separated result;
  std::vector<Pass> passes = passes_of(loops);
  std::vector<Index> last(point_count, none);  // visit of each point
  for (Index p = 0; p < static_cast<Index>(passes.size()); ++p) {
    const Index v = passes[p].point, before = std::exchange(last[v], p);
    if (before == none) continue;
    const auto is_outer = [&](Index pass) { return loops[passes[pass].loop].kind == LoopKind::Outer; };
    if (!is_outer(before) || !is_outer(p)) std::swap(passes[before].next, passes[p].next);
    passes[p].point = point_count + static_cast<Index>(result.original.size());
    result.original.push_back(v);
  }
  std::vector<char> done(passes.size(), 0);
  for (std::size_t start = 0; start < passes.size(); ++start) {
    if (done[start]) continue;
    Loop loop;
    loop.kind = LoopKind::Hole;
    for (Index p = static_cast<Index>(start); !done[p]; p = passes[p].next) {
      done[p] = 1;
      loop.points.push_back(passes[p].point);
      if (loops[passes[p].loop].kind == LoopKind::Outer) loop.kind = LoopKind::Outer;
    }
    result.loops.push_back(std::move(loop));
  }
  return result;
}

}  // namespace rimline
