// SPDX-License-Identifier: GPL-3.0-or-later
// Section 5, or ours in its place: from loops to the map and the mesh.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Section 5, eq. (4): the rim of the disc is the longest outer loop; others are filled (section 6).
void map_to_the_disc(Work& work);

// Section 5, the Delaunay triangulation.
void triangulate_the_disc(Work& work);

// Ours: each component its own patch, its holes kept, refined by flips in space. Map and mesh at once.
void mesh_patches(Work& work);

}  // namespace rimline::pipeline
