// SPDX-License-Identifier: GPL-3.0-or-later
// Which way the mesh faces.
#pragma once

#include <vector>

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"

namespace rimline::pipeline {

// The input's normals, one per point of the arrangement; empty where there are none.
std::vector<Point> arranged_normals(const Given& given, const PreparedPoints& prepared);

// The mesh turned as a whole to face the normals, or `up` where there are none; its map and loops with it.
MappedMesh orient_whole(MappedMesh mesh, std::vector<Point> normals, Point up);

// The same for each patch, which until here faces its own way. `domain` is the map's.
MappedMesh orient_patches(MappedMesh mesh, std::vector<Point> normals, Point up, Domain domain);

}  // namespace rimline::pipeline
