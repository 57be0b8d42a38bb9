// SPDX-License-Identifier: GPL-3.0-or-later
// The smoother of the multigrid: Gauss-Seidel inside blocks of rows, Jacobi between them, so that blocks run
// at the same time and the result does not depend on threads.
#pragma once

#include <vector>

#include "solve/sparse.h"

namespace rimline {

// r = b - A x.
void compute_residual(const SymmetricMatrix& a, const UV* b, const UV* x, UV* r);

// One forward sweep from x = 0. `inverse` is of the diagonal.
void sweep_forward(const SymmetricMatrix& a, const std::vector<double>& inverse, const UV* b, UV* x);

// The residual right after sweep_forward: what the sweep has seen cancels.
void residual_after_forward(const SymmetricMatrix& a, const UV* x, UV* r);

// One backward sweep, in place: the adjoint of sweep_forward. `outside` is work space, as long as x.
void sweep_backward(const SymmetricMatrix& a, const std::vector<double>& inverse, const UV* b, UV* outside,
                    UV* x);

}  // namespace rimline
