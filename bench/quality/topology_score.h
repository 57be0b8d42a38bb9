// SPDX-License-Identifier: GPL-3.0-or-later
// Are surfaces that are no disc meshed as what they are, and points that no loop covers labelled?
#pragma once

#include "quality/case.h"
#include "quality/method.h"
#include "quality/metrics.h"

namespace rimline::bench {

// Of a case of the group "topology":
//   accepted      there is a mesh
//   verdict_right accepted, with the Euler number and the number of loops of the shape
Metrics score_verdict(const Case& c, const Outcome& outcome);

// loops_found_or_labelled: true loops that are covered to 0.9 within one spacing by one returned loop, or
// have 0.8 of their points labelled undersampled.
Metrics score_labels(const Case& c, const Outcome& outcome);

}  // namespace rimline::bench
