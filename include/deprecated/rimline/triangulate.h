// SPDX-License-Identifier: GPL-3.0-or-later
// The former name of delaunay.h, for one release.
#pragma once

#include "rimline/delaunay.h"
