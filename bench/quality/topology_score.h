// SPDX-License-Identifier: GPL-3.0-or-later
// Are surfaces that no disc can map to named, and points that no loop covers labelled?
#pragma once

#include "quality/case.h"
#include "quality/method.h"
#include "quality/metrics.h"

namespace rimline::bench {

// Of a case of the group "topology":
//   accepted      there is a mesh
//   named         the refusal says what is wrong: "closed", "handle" or "orient" as the shape has it
//   verdict_right accepted and with two boundary loops (pipe), or refused and named (the others)
Metrics score_verdict(const Case& c, const Outcome& outcome);

// What `label` holds. docs/formats.md
enum class Label : std::uint8_t { Interior, Boundary, Undersampled, Crease, Stray };

// loops_found_or_labelled: true loops that are covered to 0.9 within one spacing by one returned loop, or
// have 0.8 of their points labelled undersampled.
Metrics score_labels(const Case& c, const Outcome& outcome);

}  // namespace rimline::bench
