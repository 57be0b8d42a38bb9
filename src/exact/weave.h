// SPDX-License-Identifier: GPL-3.0-or-later
// How much closer points lie in one direction than in another, as along and across scan lines.
#pragma once

#include <vector>

namespace rimline::exact {

// A symmetric positive matrix of determinant 1: squared lengths are xx x^2 + 2 xy x y + yy y^2.
struct Weave {
  double xx = 1, xy = 0, yy = 1;
};

struct Offset {
  double x, y;
};

// Under which points lie alike in all directions: offsets to near neighbours, in units of about the spacing,
// from any number of points. Close ones count most. The identity where there are none.
Weave find_weave(const std::vector<Offset>& offsets);

}  // namespace rimline::exact
