// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of about four rows that depend on each other most: a coarser level of a matrix.
#pragma once

#include <vector>

#include "solve/row_matrix.h"

namespace rimline {

// The group of each row, and the rows of each group.
struct Groups {
  std::vector<Index> of;
  std::vector<Index> offsets = {0}, members;

  Index count() const { return static_cast<Index>(offsets.size()) - 1; }
};

struct Grouping {
  Groups groups;
  RowMatrix sums;  // of the matrix over its groups of rows and columns: as many rows as groups
};

// Pairs of pairs, each row with the row that it depends on most (Notay 2012, section 3).
Grouping group_rows(const RowMatrix& matrix);

}  // namespace rimline
