// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of boundary, parameterize and reconstruct, before and after the library's call.
#pragma once

#include <vector>

#include "arguments.h"
#include "outputs.h"
#include "picture.h"
#include "rimline/cloud.h"
#include "rimline/pipeline.h"
#include "session.h"

namespace rimline::cli {

struct Inputs {
  Cloud cloud;
  Given given;
};

// All files that the arguments ask for, `main_output` first.
std::vector<Output> outputs_of(const MethodArguments& arguments, const Output& main_output);

// The points, their normals and the given loops.
Inputs read_inputs(const MethodArguments& arguments, Session& session);

// The report with the reader's warnings before its own.
Report told(const Inputs& inputs, Report report);

// Writes the loops, the picture and the report, as far as they were asked for, then prints the summary. The
// stages Read and Write join those of the report; Write has grown by what came since session.clock() entered
// it, less the report itself.
void finish(const MethodArguments& arguments, const std::vector<Output>& outputs, const Scene& scene,
            Report report, Session& session);

}  // namespace rimline::cli
