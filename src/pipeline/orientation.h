// SPDX-License-Identifier: GPL-3.0-or-later
// Orients the mesh.
#pragma once

#include <vector>

#include "pipeline/mapped_mesh.h"
#include "pipeline/prepare.h"

namespace rimline::pipeline {

// The input's normals, one per point of the arrangement; empty where there are none.
std::vector<Point> arranged_normals(const Given& given, const PreparedPoints& prepared);

// Turns the mesh as a whole to face the normals, or `up` without normals; its map and loops are turned with
// it.
MappedMesh orient_whole(MappedMesh mesh, std::vector<Point> normals, Point up);

// The same for each patch by itself. `domain` is the map's.
MappedMesh orient_patches(MappedMesh mesh, std::vector<Point> normals, Point up, Domain domain);

}  // namespace rimline::pipeline
