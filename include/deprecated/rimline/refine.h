// SPDX-License-Identifier: GPL-3.0-or-later
// The former name of refine_surface.h, for one release.
#pragma once

#include "rimline/refine_surface.h"
