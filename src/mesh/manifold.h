// SPDX-License-Identifier: GPL-3.0-or-later
// Validity of a mesh, checked on its arrays alone.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/run.h"

namespace rimline {

// Returns "" or the first fault: there is no triangle; a corner is repeated or no vertex; a triangle is there
// twice; an edge has more than two triangles, or two in the same direction (only where `orientable`); the
// triangles of a vertex form more than one fan; the open edges are not those of the loops, without regard to
// direction. Linear time. The same text for any number of threads.
std::string fault_of(std::span<const Triangle> triangles, std::size_t vertices,
                     const std::vector<Loop>& loops, bool orientable, const Run& run);

}  // namespace rimline
