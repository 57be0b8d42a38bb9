// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that the search may leave out.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "local/samples.h"
#include "rimline/run.h"
#include "search/search_options.h"
#include "surface/local_size.h"
#include "surface/triangle_set.h"

namespace rimline {

constexpr std::uint32_t not_candidate = ~std::uint32_t{0};

// The candidate triangles and how they are connected.
struct Candidates {
  std::vector<Index> triangles;  // ascending
  std::vector<double> gain;      // log odds of leaving each out, without the cost of corners
  std::vector<double> log_ratio, spread;
  std::vector<std::array<Index, 3>> beside;  // the triangles across its edges, or none
  std::vector<std::array<std::uint32_t, 3>>
      candidate_beside;  // their positions in `triangles`, or `not_candidate`
  std::vector<std::array<double, 3>>
      contrast;                 // log odds of a rim between the triangle, left out, and each neighbour, kept
  std::vector<Index> vertices;  // corners of the candidates, ascending
  std::vector<double> even;     // evenness of the rim at each vertex, 0 to 1; empty: not known
  std::vector<std::array<std::uint32_t, 3>> slots;  // position of each triangle's vertices in `vertices`
};

// The search starts at triangles of the rim that are large for their surroundings, and at inner triangles
// that are too large. It adds doubtful triangles beside these, up to model::candidate_deepest layers. A
// triangle at a vertex marked in `excluded` is no candidate, unless it is plainly too large.
Candidates find_candidates(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples,
                           const std::vector<std::uint8_t>& excluded, const SearchOptions& options,
                           const Run& run);

}  // namespace rimline
