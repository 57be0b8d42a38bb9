// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/sweeps.h"

#include "solve/blocks.h"

namespace rimline {

void compute_residual(const SymmetricMatrix& a, const UV* b, const UV* x, UV* r) {
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) r[i] = b[i] - a.diagonal[i] * x[i] - a.off_diagonal(i, x);
  });
}

// One forward Gauss-Seidel sweep inside each block, from x = 0: what lies outside the block or above the
// diagonal is still 0.
void sweep_forward(const SymmetricMatrix& a, const std::vector<double>& inverse, const UV* b, UV* x) {
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      UV sum = b[i];
      for (Index e = a.offsets[i]; e < a.offsets[i + 1] && a.columns[e] < i; ++e) {
        if (a.columns[e] >= begin) sum = sum - a.values[e] * x[a.columns[e]];
      }
      x[i] = inverse[i] * sum;
    }
  });
}

// The residual right after sweep_forward: what the sweep has seen cancels.
void residual_after_forward(const SymmetricMatrix& a, const UV* x, UV* r) {
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      UV sum;
      Index e = a.offsets[i + 1] - 1;
      for (; e >= a.offsets[i] && a.columns[e] > i; --e) sum = sum - a.values[e] * x[a.columns[e]];
      for (Index f = a.offsets[i]; f <= e && a.columns[f] < begin; ++f)
        sum = sum - a.values[f] * x[a.columns[f]];
      r[i] = sum;
    }
  });
}

// One backward sweep inside each block, in place: the adjoint of sweep_forward, so that the cycle is
// symmetric. What lies outside the block is read as it was before, into `outside`.
void sweep_backward(const SymmetricMatrix& a, const std::vector<double>& inverse, const UV* b, UV* outside,
                    UV* x) {
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      UV sum = b[i];
      Index e = a.offsets[i];
      for (; e < a.offsets[i + 1] && a.columns[e] < begin; ++e) sum = sum - a.values[e] * x[a.columns[e]];
      for (Index f = a.offsets[i + 1] - 1; f >= e && a.columns[f] >= end; --f)
        sum = sum - a.values[f] * x[a.columns[f]];
      outside[i] = sum;
    }
  });
  for_each_block(a.size(), [&](Index, Index begin, Index end) {
    for (Index i = end - 1; i >= begin; --i) {
      UV sum = outside[i];
      for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
        const Index j = a.columns[e];
        if (j >= begin && j < end) sum = sum - a.values[e] * x[j];
      }
      x[i] = inverse[i] * sum;
    }
  });
}

}  // namespace rimline
