// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arrays.h"
#include "rimline/measure.h"

namespace rimline::python {

// Arrays by the names of the members.
Dict distortion_values(Distortion::Values values);

}  // namespace rimline::python
