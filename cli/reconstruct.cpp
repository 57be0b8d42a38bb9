// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "columns.h"
#include "method.h"
#include "rimline/io.h"
#include "subcommands.h"

namespace rimline::cli {
namespace {

void run_reconstruct(const MethodArguments& arguments) {
  const auto outputs = outputs_of(arguments, {"--output", arguments.output, {}, true, check_mesh_path});
  check_outputs(outputs);
  Session session(arguments.common);
  Inputs in = read_inputs(arguments, session);
  const ReconstructResult result = reconstruct(in.cloud.points, arguments.options(), session.run(), in.given);
  session.clock().enter(Stage::Write);
  put_map_columns(in.cloud, result.uv, result.boundary.boundary);
  if (!result.patch.empty()) set_column(in.cloud, make_column("component", result.patch));
  write_mesh(arguments.output, in.cloud, result.triangles, session.run());
  finish(arguments, outputs,
         {.points = in.cloud.points,
          .boundary = result.boundary,
          .uv = result.uv,
          .triangles = result.triangles,
          .up = arguments.up,
          .panel_size = arguments.picture_size},
         result.boundary.report, session);
}

}  // namespace

void add_reconstruct(CLI::App& tool) {
  auto arguments = std::make_shared<MethodArguments>();
  CLI::App& command =
      add_subcommand(tool, "reconstruct",
                     "Make a triangle mesh of the points that ends exactly at the boundary of their surface.",
                     "rimline reconstruct scan.ply -o mesh.ply --loops loops.json --report report.json");
  add_input(command, arguments->input);
  add_output(command, arguments->output, "MESH.{ply,obj,off,stl,glb}",
             "The input points as vertices, with triangles; PLY also has u, v and boundary, and goes to "
             "standard output for -",
             true);
  add_method(command, *arguments);
  command.callback([arguments] { run_reconstruct(*arguments); });
}

}  // namespace rimline::cli
