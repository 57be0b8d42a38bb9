// SPDX-License-Identifier: GPL-3.0-or-later
// A boundary made by hand in the place of one that was found.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Puts the given loops, in ids of the arrangement, in the place of those found. Throws BadOption, naming the
// points of the loops that take no part.
void take_given_loops(Work& work);

// Loops made by hand say what the surface is: points that none of them bounds are an error, not a remainder.
// Throws UnreachableInterior with them.
void check_reached(const std::vector<Index>& left_out);

}  // namespace rimline::pipeline
