// SPDX-License-Identifier: GPL-3.0-or-later
// The former name of find_genetic_loop.h, for one release.
#pragma once

#include "rimline/find_genetic_loop.h"
