// SPDX-License-Identifier: GPL-3.0-or-later
// Does a polyline on a surface that is known by points cross itself?
#pragma once

#include "quality/case.h"
#include "quality/edge_set.h"

namespace rimline::bench {

// Pairs of edges of loops, of one or of two, without a common point, that cross properly when seen along the
// normal of the surface between them, and lie less than one spacing apart along it. The normal is that of the
// least squares plane through the twelve nearest points of each of the four ends.
std::size_t count_crossings(const Case& c, const EdgeSet& loops);

}  // namespace rimline::bench
