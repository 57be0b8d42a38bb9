// SPDX-License-Identifier: GPL-3.0-or-later
// Which way the mesh faces.
#pragma once

#include "pipeline/work.h"

namespace rimline::pipeline {

// Turns the whole mesh to face the input's normals, or up; its map and loops with it.
void orient_whole(Work& work);

// The same for each of `count` patches, which until here face their own way.
void orient_patches(Work& work, std::size_t count);

}  // namespace rimline::pipeline
