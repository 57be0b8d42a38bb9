// SPDX-License-Identifier: GPL-3.0-or-later
// How good boundary points and boundary loops are. Numbers of the same name agree with score.py.
#pragma once

#include <span>
#include <vector>

#include "quality/case.h"
#include "quality/metrics.h"

namespace rimline::bench {

using LoopIds = std::vector<std::vector<Index>>;

// The set of points that a method calls boundary, ids in any order, each once:
//   points_precision, points_recall, points_f1   against flag 1; points of flag 2 are not asked
//   points_f1_within_one_spacing                 a point counts where the other set has one within its
//   spacing rim_points_f1                                against the points of the true loops alone
// Empty where the case has no truth.
Metrics score_points(const Case& c, std::span<const Index> found);

// Loops, each closed and in order: all of score_points, and
//   edges_precision, edges_recall, edges_f1, loops_found, loops_true, loops_right (found == true),
//   loops_exact (true loops that were found edge for edge), all_exact (all of them and no other),
//   loops_missed (true loops of which fewer than half of the points have one of the found loops within one
//   spacing), loops_false (found ones of which fewer than half have one of the true loops),
//   length, length_over_truth, longest_loop_1 .. 4 (share of the edges of the longest true loops that the
//   best single loop has), longest_within_1 .. 4 (share of their points with a point of the best single loop
//   within one spacing), simple (no point twice in a loop), crossings (pairs of edges that cross,
//   crossings.h), crossings_of_truth.
Metrics score_loops(const Case& c, const LoopIds& loops);

// Whether 0.9 of the points of a true loop have a point of the found one within one spacing.
bool is_covered(const Case& c, const EdgeSet& loop, std::span<const Index> found);

// Ascending, each once.
std::vector<Index> points_of(const LoopIds& loops);

}  // namespace rimline::bench
