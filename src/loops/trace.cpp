// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/trace.h"

#include <utility>

#include "rimline/find_genetic_loop.h"

namespace rimline {

std::vector<Loop> trace_loops(const RimEvidence& e, const Components& components, const Run& run) {
  std::vector<Loop> loops;
  for (auto& ids : walk_rims(e.set, e.selection, run)) {
    Loop& loop = loops.emplace_back();
    loop.component = components.of_triangle[selected_triangle(e.set, e.selection, ids[0], ids[1])];
    loop.length = loop_length(e.samples.points, ids);
    loop.probability = boundary_probability(ids, e, run);
    loop.points = std::move(ids);
  }
  return loops;
}

}  // namespace rimline
