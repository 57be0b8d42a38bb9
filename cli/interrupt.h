// SPDX-License-Identifier: GPL-3.0-or-later
// Handles SIGINT, SIGTERM, SIGHUP and SIGXCPU (ulimit -t).
#pragma once

#include <atomic>

namespace rimline::cli {

// True after one of these: the target of Run::stop.
extern std::atomic<bool> interrupted;

// From here on SIGINT, SIGTERM, SIGXCPU and SIGHUP (unless it is ignored, as under nohup) set `interrupted`.
// A second one, or a stage that has not stopped after 0.8 s (a read from a pipe that gives nothing can not
// look at a flag), ends the process with status 5. SIGPIPE and SIGXFSZ are ignored: a write that fails is
// reported as such.
void catch_interrupts();

}  // namespace rimline::cli
