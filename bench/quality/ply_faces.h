// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a PLY file, which rimline::read_cloud skips.
#pragma once

#include <string>
#include <vector>

#include "rimline/mesh.h"

namespace rimline::bench {

// Ascii or binary little-endian; polygons become fans. Throws rimline::Error{CannotRead}.
std::vector<Triangle> read_ply_faces(const std::string& path);

}  // namespace rimline::bench
