// SPDX-License-Identifier: GPL-3.0-or-later
// How many threads a stage may use.
#pragma once

#include "rimline/run.h"

namespace rimline {

// The number that the run asks for, limited by the machine, and by the system where it refuses to create
// threads (a limit on processes or on address space). At least 1. The first call that may use several threads
// starts the workers: a thread that is refused later would end the process.
int thread_count(const Run& run);

}  // namespace rimline
