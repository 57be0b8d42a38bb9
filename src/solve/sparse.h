// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric sparse matrices as rows, and vectors of two columns: u and v share one matrix, so that one pass
// over it serves both.
#pragma once

#include <span>
#include <vector>

#include "rimline/points.h"

namespace rimline {

inline UV operator+(UV a, UV b) { return {a.u + b.u, a.v + b.v}; }
inline UV operator-(UV a, UV b) { return {a.u - b.u, a.v - b.v}; }
inline UV operator*(double s, UV a) { return {s * a.u, s * a.v}; }

// A symmetric matrix: both triangles are stored, the diagonal apart.
struct SymmetricMatrix {
  std::vector<double> diagonal;
  std::vector<Index> offsets = {0};  // size() + 1; row i holds [offsets[i], offsets[i + 1])
  std::vector<Index> columns;        // off the diagonal
  std::vector<double> values;        // beside columns

  Index size() const { return static_cast<Index>(diagonal.size()); }
  // What row i gives for x without the diagonal.
  UV off_diagonal(Index i, const UV* x) const {
    UV sum;
    for (Index e = offsets[i]; e < offsets[i + 1]; ++e) {
      const UV& other = x[columns[e]];
      sum.u += values[e] * other.u;
      sum.v += values[e] * other.v;
    }
    return sum;
  }
};

}  // namespace rimline
