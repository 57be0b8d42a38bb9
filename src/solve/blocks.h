// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over rows whose result does not depend on the number of threads: rows of one block are treated in
// order by one thread, and the blocks are always the same.
#pragma once

#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "solve/sparse.h"

namespace rimline {

constexpr Index rows_per_block = 8192;

inline Index block_count(Index n) { return (n + rows_per_block - 1) / rows_per_block; }

// Calls body(block, begin, end) for every block of rows.
template <class Body>
void for_each_block(Index n, const Body& body) {
  const auto run_block = [&](Index k) { body(k, k * rows_per_block, std::min(n, (k + 1) * rows_per_block)); };
  if (block_count(n) == 1) return run_block(0);
  run_tasks(static_cast<std::size_t>(block_count(n)),
            [&](std::size_t k) { run_block(static_cast<Index>(k)); });
}

// Calls body(row) for every row.
template <class Body>
void for_each_row(Index n, const Body& body) {
  for_each_block(n, [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) body(i);
  });
}

// The sum of body(row) over all rows: in order inside a block, then block after block.
template <class Body>
UV sum_of(Index n, const Body& body) {
  std::vector<UV> partial(block_count(n));
  for_each_block(n, [&](Index block, Index begin, Index end) {
    UV sum;
    for (Index i = begin; i < end; ++i) sum = sum + body(i);
    partial[block] = sum;
  });
  UV sum;
  for (const UV& p : partial) sum = sum + p;
  return sum;
}

}  // namespace rimline
