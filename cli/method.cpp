// SPDX-License-Identifier: GPL-3.0-or-later
#include "method.h"

#include "rimline/io.h"
#include "summary.h"

namespace rimline::cli {

std::vector<Output> outputs_of(const MethodArguments& arguments, const Output& main_output) {
  return {main_output,
          {"--loops", arguments.loops, {}, true, check_loops_path},
          {"--picture", arguments.picture, {"png", "svg"}, false},
          {"--report", arguments.report, {"json"}}};
}

Inputs read_inputs(const MethodArguments& arguments, const Run& run) {
  if (arguments.input == "-" && arguments.use_loops == "-") {
    throw Error(ErrorCode::BadOption, "IN and --use-loops can not both be standard input");
  }
  Inputs inputs;
  inputs.cloud = read_cloud(arguments.input, run);
  inputs.given.normals = inputs.cloud.normals();
  if (!arguments.use_loops.empty()) {
    inputs.given.loops = read_loops(arguments.use_loops, inputs.cloud.points.size());
  }
  return inputs;
}

void finish(const MethodArguments& arguments, const std::vector<Output>& outputs, const Scene& scene,
            const Report& report, Session& session) {
  const Run& run = session.run();
  run.check_cancel();
  if (!arguments.loops.empty()) write_loops(arguments.loops, report.loops, scene.points, run);
  if (!arguments.picture.empty()) write_picture(arguments.picture, scene, run);
  run.check_cancel();
  if (!arguments.report.empty()) write_text(arguments.report, to_json(report));
  session.bar().erase();
  if (!arguments.common.quiet) {
    print_summary(any_standard(outputs) ? stderr : stdout, report, list_files(outputs), session.seconds());
  }
}

}  // namespace rimline::cli
