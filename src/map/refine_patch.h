// SPDX-License-Identifier: GPL-3.0-or-later
// refine_patch() for those who know the points' cells already.
#pragma once

#include "map/pinches.h"
#include "map/stars.h"
#include "rimline/refine.h"

namespace rimline {

// `outline` has ids of the points and, beyond them, of copies where it touches itself.
Patch refine_patch(Points points, const Neighbours& neighbours, const Stars& stars, const Separated& outline,
                   const RefineOptions& options, const Run& run);

}  // namespace rimline
