// SPDX-License-Identifier: GPL-3.0-or-later
// Row factors that make the column sums of a matrix nearly zero.
#pragma once

#include <vector>

#include "rimline/run.h"
#include "solve/row_matrix.h"

namespace rimline {

// Rows that sum to zero are the rates of a random walk, and factors that make the columns sum to zero are how
// often each row is visited: the walk's stationary distribution. With both, the matrix's symmetric part is
// diagonally dominant, and coarser levels that add up rows see what flows between groups as it is. Where
// neighbours are mutual all factors are 1; where a dense region does not list its sparse neighbours, they
// differ by orders of magnitude. The diagonal is not read. Positive, their mean 1; approximate, by
// multilevel aggregation (Horton & Leutenegger 1994, "A multi-level solution algorithm for steady-state
// Markov chains").
std::vector<double> balancing_rows(const RowMatrix& rates, const Run& run);

// Multiplies each row by its factor.
void scale_rows(RowMatrix& matrix, const std::vector<double>& factors);

}  // namespace rimline
