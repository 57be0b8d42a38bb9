// SPDX-License-Identifier: GPL-3.0-or-later
// The method from end to end: find_boundary(), parameterize(), reconstruct().
#pragma once

#include "rimline/find_boundary.h"
#include "rimline/parameterize.h"
#include "rimline/reconstruct.h"
