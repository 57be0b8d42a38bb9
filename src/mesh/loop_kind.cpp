// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/mesh.h"

namespace rimline {

const char* name(LoopKind kind) { return kind == LoopKind::Outer ? "outer" : "hole"; }

}  // namespace rimline
