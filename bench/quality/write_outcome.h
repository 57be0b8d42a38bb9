// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "quality/method.h"

namespace rimline::bench {

// SET.METHOD.loops.json and SET.METHOD.mesh.ply (with u and v where there are any), for score.py and for
// eyes.
void write_outcome(const std::string& folder, const Case& c, const std::string& method,
                   const Outcome& outcome);

}  // namespace rimline::bench
