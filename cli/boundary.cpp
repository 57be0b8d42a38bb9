// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "columns.h"
#include "method.h"
#include "rimline/io.h"
#include "subcommands.h"

namespace rimline::cli {
namespace {

void run_boundary(const MethodArguments& arguments) {
  const Options options = arguments.options();
  const auto outputs = outputs_of(arguments, {"--output", arguments.output, {"ply"}});
  check_outputs(outputs);
  Session session(arguments.common);
  Inputs in = read_inputs(arguments, session);
  BoundaryResult result = find_boundary(in.cloud.points, options, session.run(), in.given);
  for (const std::string& flag : arguments.flags_of_mesh()) {
    result.report.warnings.push_back(flag + " counts in parameterize and reconstruct alone");
  }
  session.clock().enter(Stage::Write);
  if (!arguments.output.empty()) {
    put_boundary_columns(in.cloud, result);
    write_cloud(arguments.output, in.cloud, session.run());
  }
  finish(arguments, outputs,
         {.points = in.cloud.points,
          .boundary = result,
          .up = arguments.up,
          .panel_size = arguments.picture_size,
          .panels = arguments.panels},
         told(in, result.report), session);
}

}  // namespace

void add_boundary(CLI::App& tool) {
  auto arguments = std::make_shared<MethodArguments>();
  CLI::App& command = add_subcommand(
      tool, "boundary", "Find the boundary of the surface that the points were taken from, as ordered loops.",
      "rimline boundary scan.ply -o points.ply --loops loops.json");
  add_input(command, arguments->input);
  add_output(
      command, arguments->output, "POINTS.ply",
      "The input with boundary, loop, candidate, p_value and score for every point, and what the preset "
      "adds; - for standard output",
      false);
  add_method(command, *arguments);
  command.callback([arguments] { run_boundary(*arguments); });
}

}  // namespace rimline::cli
