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

// The candidate triangles, and how they hang together.
struct Candidates {
  std::vector<Index> triangles;  // ascending
  std::vector<double> gain;      // of leaving each out, before corners are looked at
  std::vector<double> log_ratio, spread;
  std::vector<std::array<Index, 3>> beside;  // the triangles across its edges, or none
  std::vector<std::array<std::uint32_t, 3>>
      candidate_beside;                         // of those the positions here, or `not_candidate`
  std::vector<std::array<double, 3>> contrast;  // worth of a rim between it, left out, and each of them, kept
  std::vector<Index> vertices;                  // of these triangles, ascending
  std::vector<double> even;                     // how even the rim at each of these is known to be; or empty
  std::vector<std::array<std::uint32_t, 3>> slots;  // position of each triangle's vertices in `vertices`
};

// Starts from the triangles at the rim that are large for where they are and from those inside that are too
// large, and takes in what is doubtful beside these. Triangles at a vertex that is marked in `excluded` are
// left alone, unless they are plainly too large.
Candidates find_candidates(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples,
                           const std::vector<std::uint8_t>& excluded, const SearchOptions& options,
                           const Run& run);

}  // namespace rimline
