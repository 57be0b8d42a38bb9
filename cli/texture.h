// SPDX-License-Identifier: GPL-3.0-or-later
// A texture: properties of the points, laid out by the map.
#pragma once

#include <string>
#include <vector>

#include "rimline/cloud.h"
#include "rimline/pipeline.h"

namespace rimline::cli {

// Throws BadOption where the points have neither that property nor, where its name is empty, colours.
void check_texture(const Cloud& cloud, const std::string& property);

// `size` pixels each way, as the bytes of a PNG; its first row is at v = 1. uv must lie between 0 and 1.
// Colours of the points (red, green, blue), or a property from black at its least to white at its greatest
// value, go over the triangles linearly. Charts bleed a few pixels over their outlines, so that no seam
// shows.
std::string bake_texture(const Cloud& cloud, const ReconstructResult& result, const std::string& property,
                         int size, const Run& run);

}  // namespace rimline::cli
