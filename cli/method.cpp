// SPDX-License-Identifier: GPL-3.0-or-later
#include "method.h"

#include <algorithm>

#include "rimline/io.h"
#include "standard_streams.h"
#include "summary.h"
#include "uv_picture.h"

namespace rimline::cli {

std::vector<Output> outputs_of(const MethodArguments& arguments, const Output& main_output) {
  return {main_output,
          {"--loops", arguments.loops, {}, true, check_loops_path},
          {"--picture", arguments.picture, {"png", "svg"}, false},
          {"--uv-picture", arguments.uv_picture, {"png", "svg"}, false},
          {"--report", arguments.report, {"json"}},
          {"--history", arguments.history, {"json"}}};
}

Inputs read_inputs(const MethodArguments& arguments, Session& session) {
  if (arguments.input.path == "-" && arguments.use_loops == "-") {
    throw Error(ErrorCode::BadOption, "IN and --use-loops can not both be standard input");
  }
  if (arguments.reference == "-") {
    throw Error(ErrorCode::BadOption, "--reference wants a file, not standard input");
  }
  session.clock().enter(Stage::Read);
  Inputs inputs;
  inputs.cloud = read_cloud(arguments.input.path, arguments.input.filter, session.run());
  inputs.given.normals = inputs.cloud.normals();
  inputs.given.raster = inputs.cloud.raster();
  inputs.given.viewpoint = arguments.viewpoint;
  if (!arguments.use_loops.empty()) {
    inputs.given.loops = read_loops(arguments.use_loops, inputs.cloud.points.size(), session.run());
    if (inputs.given.loops.empty())
      inputs.cloud.warnings.push_back(arguments.use_loops + ": has no loops, so they are looked for");
  }
  if (!arguments.reference.empty()) {
    MeshFile reference = read_mesh(arguments.reference, session.run());
    inputs.given.reference = {arguments.reference, std::move(reference.cloud.points),
                              std::move(reference.triangles)};
  }
  session.clock().leave();
  return inputs;
}

namespace {

// Adds the costs of reading and writing around the library's; the library's part of writing is the result.
void add_costs(std::vector<StageCost>& stages, const std::vector<StageCost>& around) {
  for (const StageCost& cost : around) {
    const auto known = std::ranges::find(stages, cost.stage, &StageCost::stage);
    if (known != stages.end()) {
      known->seconds += cost.seconds;
      known->peak_bytes = std::max(known->peak_bytes, cost.peak_bytes);
    } else {
      stages.insert(cost.stage == Stage::Read ? stages.begin() : stages.end(), cost);
    }
  }
}

}  // namespace

Report told(const Inputs& inputs, Report report) {
  const auto& warnings = inputs.cloud.warnings;
  report.warnings.insert(report.warnings.begin(), warnings.begin(), warnings.end());
  return report;
}

void finish(const MethodArguments& arguments, const std::vector<Output>& outputs, const Scene& scene,
            Report report, Session& session) {
  const Run& run = session.run();
  run.check_cancel();
  if (!arguments.loops.empty()) {
    write_loops(arguments.loops, report.loops, scene.points.first(report.points.input), run);
  }
  if (!arguments.history.empty()) {
    write_text(arguments.history, history_to_json(scene.boundary.history, report.points.input));
  }
  if (!arguments.picture.empty()) write_picture(arguments.picture, scene, run);
  if (!arguments.uv_picture.empty()) write_uv_picture(arguments.uv_picture, scene, run);
  run.check_cancel();
  session.clock().leave();
  add_costs(report.stages, session.clock().costs());
  if (!arguments.report.empty()) write_text(arguments.report, to_json(report));
  session.bar().erase();
  if (arguments.common.quiet) return;
  print_notice(summary(report, list_files(outputs), session.seconds()), any_standard(outputs));
}

}  // namespace rimline::cli
