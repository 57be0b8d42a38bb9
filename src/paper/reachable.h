// SPDX-License-Identifier: GPL-3.0-or-later
// Points for which eq. (4) is singular.
#pragma once

#include <span>
#include <vector>

#include "rimline/neighbours.h"

namespace rimline {

// Ids of the points, ascending, from which no chain of neighbours (each among the nearest `k` of the one
// before) leads to a point of the loop.
std::vector<Index> unreachable_points(const Neighbours& neighbours, int k, std::span<const Index> loop);

}  // namespace rimline
