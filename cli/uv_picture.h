// SPDX-License-Identifier: GPL-3.0-or-later
// The map by itself: its layout in the plane, and what a checkerboard in the plane looks like in space.
#pragma once

#include <string>

#include "picture.h"

namespace rimline::cli {

// PNG or SVG by the ending: two panels, the layout with its edges and outlines over the checkerboard, and the
// surface with the same squares. Squares that look alike on the surface mean little distortion. Throws
// CannotWrite, Cancelled.
void write_uv_picture(const std::string& path, const Scene& scene, const Run& run);

}  // namespace rimline::cli
