// SPDX-License-Identifier: GPL-3.0-or-later
// How many threads a stage may use.
#pragma once

#include "rimline/run.h"

namespace rimline {

// As many as the run asks for, and at most those of the machine; fewer where the system refuses to make them
// (a limit on processes or on address space). At least 1. The first call that may use more than one starts
// the workers: made later, a thread that is refused would end the process.
int thread_count(const Run& run);

}  // namespace rimline
