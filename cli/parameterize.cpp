// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "columns.h"
#include "method.h"
#include "rimline/io.h"
#include "subcommands.h"

namespace rimline::cli {
namespace {

void run_parameterize(const MethodArguments& arguments) {
  const Options options = arguments.options();
  const auto outputs = outputs_of(arguments, {"--output", arguments.output, {"ply"}});
  check_outputs(outputs);
  Session session(arguments.common);
  Inputs in = read_inputs(arguments, session);
  const ParameterizeResult result = parameterize(in.cloud.points, options, session.run(), in.given);
  session.clock().enter(Stage::Write);
  put_map_columns(in.cloud, result.uv, result.boundary.boundary);
  write_cloud(arguments.output, in.cloud, session.run());
  finish(arguments, outputs,
         {.points = in.cloud.points,
          .boundary = result.boundary,
          .uv = result.uv,
          .up = arguments.up,
          .panel_size = arguments.picture_size,
          .panels = arguments.panels},
         told(in, result.boundary.report), session);
}

}  // namespace

void add_parameterize(CLI::App& tool) {
  auto arguments = std::make_shared<MethodArguments>();
  CLI::App& command =
      add_subcommand(tool, "parameterize", "Map the points to the plane, their boundary to the unit circle.",
                     "rimline parameterize scan.ply -o uv.ply");
  add_input(command, arguments->input);
  add_output(command, arguments->output, "OUT.ply",
             "The input with u, v and boundary for every point; - for standard output", true);
  add_method(command, *arguments);
  command.callback([arguments] { run_parameterize(*arguments); });
}

}  // namespace rimline::cli
