// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "columns.h"
#include "method.h"
#include "outputs.h"
#include "rimline/formats.h"
#include "rimline/io.h"
#include "subcommands.h"
#include "texture.h"

namespace rimline::cli {
namespace {

// Adds the requested properties: which vertices and triangles fill holes, and the distortion of the map.
// Returns the properties of the faces.
std::vector<Column> put_mesh_columns(const MethodArguments& arguments, const ReconstructResult& result,
                                     Cloud& cloud) {
  std::vector<Column> of_faces;
  if (arguments.holes && arguments.holes->fill) {
    std::vector<std::uint8_t> filled(cloud.points.size() - result.added.size(), 0);
    filled.resize(cloud.points.size(), 1);
    set_column(cloud, make_column("filled", filled));
    of_faces.push_back(make_column("filled", result.filled));
  }
  if (arguments.distortion) {
    for (Column& column : distortion_columns(result.distortion.point)) set_column(cloud, std::move(column));
    for (Column& column : distortion_columns(result.distortion.triangle))
      of_faces.push_back(std::move(column));
  }
  if (std::ranges::any_of(result.chart, [](Index c) { return c > 0; }))
    of_faces.push_back(make_column("chart", result.chart));
  return of_faces;
}

// Writes loops and report although there is no mesh.
void write_without_mesh(const MethodArguments& arguments, const Inputs& in, const BoundaryResult& found,
                        Session& session) {
  if (!arguments.loops.empty()) write_loops(arguments.loops, found.loops, in.cloud.points, session.run());
  if (!arguments.report.empty()) write_text(arguments.report, to_json(found.report));
}

// The result where nothing was found.
BoundaryResult nothing_found(const MethodArguments& arguments, const Inputs& in, const Error& error) {
  BoundaryResult result;
  result.report.options = arguments.options();
  result.report.seed = arguments.common.seed;
  result.report.points.input = in.cloud.points.size();
  result.report.warnings = {error.what()};
  return result;
}

ReconstructResult mesh_or_write_rest(const MethodArguments& arguments, const Options& options,
                                     const Inputs& in, Session& session) {
  try {
    return reconstruct(in.cloud.points, options, session.run(), in.given);
  } catch (const NoMesh& error) {
    write_without_mesh(arguments, in, error.found, session);
    throw;
  } catch (const Error& error) {
    if (exit_status(error.code()) == exit_status(ErrorCode::NoClosedLoop))
      write_without_mesh(arguments, in, nothing_found(arguments, in, error), session);
    throw;
  }
}

// The options, with the map that a texture needs.
Options options_of(const MethodArguments& arguments) {
  Options options = arguments.options();
  if (arguments.texture_size == 0) {
    if (arguments.texture_property.empty()) return options;
    throw Error(ErrorCode::BadOption, "--texture-property is for a texture; give --texture-size too");
  }
  const std::string ending = ending_of(arguments.output);
  if (ending != "obj" && ending != "glb")
    throw Error(ErrorCode::BadOption, "--texture-size wants a mesh that ends in .obj or .glb");
  if (!counts(UsedBy::Default, options) || !has_map(options.map.domain) ||
      options.map.uv_scale == UvScale::Real) {
    throw Error(
        ErrorCode::BadOption,
        "--texture-size wants a map in the square from 0 to 1: of the preset default, to any domain but "
        "none, at --uv-scale unit");
  }
  options.map.uv_scale = UvScale::Unit;
  return options;
}

void run_reconstruct(const MethodArguments& arguments) {
  const Options options = options_of(arguments);
  const auto outputs = outputs_of(arguments, {"--output", arguments.output, {}, true, check_mesh_path});
  check_outputs(outputs);
  Session session(arguments.common);
  Inputs in = read_inputs(arguments, session);
  if (arguments.texture_size > 0) check_texture(in.cloud, arguments.texture_property);
  ReconstructResult result = mesh_or_write_rest(arguments, options, in, session);
  session.clock().enter(Stage::Write);
  add_fill_vertices(in.cloud, result.added, result.boundary);
  put_map_columns(in.cloud, result.uv, result.boundary.boundary);
  if (!result.patch.empty()) set_column(in.cloud, make_column("component", result.patch));
  const std::vector<Column> face_columns = put_mesh_columns(arguments, result, in.cloud);
  Dress dress{result.seams};
  if (arguments.texture_size > 0) {
    dress.picture =
        bake_texture(in.cloud, result, arguments.texture_property, arguments.texture_size, session.run());
  }
  const WrittenMesh written =
      write_mesh(arguments.output, in.cloud, result.triangles, session.run(), face_columns, dress);
  Report report = told(in, result.boundary.report);
  report.offset = written.offset;
  report.warnings.insert(report.warnings.end(), written.notices.begin(), written.notices.end());
  finish(arguments, outputs,
         {.points = in.cloud.points,
          .boundary = result.boundary,
          .uv = result.uv,
          .triangles = result.triangles,
          .seams = result.seams,
          .chart = result.chart,
          .up = arguments.up,
          .panel_size = arguments.picture_size,
          .panels = arguments.panels},
         report, session);
}

}  // namespace

void add_reconstruct(CLI::App& tool) {
  auto arguments = std::make_shared<MethodArguments>();
  CLI::App& command =
      add_subcommand(tool, "reconstruct",
                     "Make a triangle mesh of the points that ends exactly at the boundary of their surface.",
                     "rimline reconstruct scan.ply -o mesh.ply --loops loops.json --report report.json");
  add_input(command, arguments->input);
  add_output(command, arguments->output,
             fmt::format("MESH.{{{}}}", fmt::join(written_endings(FormatUse::WriteMesh), ",")),
             "The input points as vertices, with triangles; PLY also has u, v and boundary, and goes to "
             "standard output for -",
             true);
  add_method(command, *arguments);
  add_mesh_method(command, *arguments);
  command.callback([arguments] { run_reconstruct(*arguments); });
}

}  // namespace rimline::cli
