// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse matrices as rows.
#pragma once

#include <vector>

#include "solve/sparse.h"

namespace rimline {

// A square matrix as rows, the diagonal apart.
struct RowMatrix {
  std::vector<double> diagonal;
  std::vector<Index> offsets = {0};  // size() + 1; row i holds [offsets[i], offsets[i + 1])
  std::vector<Index> columns;        // off the diagonal, in any order
  std::vector<double> values;        // beside columns

  Index size() const { return static_cast<Index>(diagonal.size()); }
  // What row i gives for x.
  UV times(Index i, const UV* x) const {
    UV sum = diagonal[i] * x[i];
    for (Index e = offsets[i]; e < offsets[i + 1]; ++e) sum = sum + values[e] * x[columns[e]];
    return sum;
  }
};

}  // namespace rimline
