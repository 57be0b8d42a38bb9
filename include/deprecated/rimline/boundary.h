// SPDX-License-Identifier: GPL-3.0-or-later
// The former name of score_boundary.h, for one release.
#pragma once

#include "rimline/score_boundary.h"
