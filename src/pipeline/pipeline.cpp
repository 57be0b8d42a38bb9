// SPDX-License-Identifier: GPL-3.0-or-later
// The method on one screen.
#include "rimline/pipeline.h"

#include <algorithm>
#include <cmath>

#include "pipeline/left_out.h"
#include "pipeline/measure.h"
#include "pipeline/method.h"
#include "pipeline/prepare.h"
#include "pipeline/report.h"
#include "pipeline/results.h"
#include "pipeline/score.h"
#include "pipeline/units.h"
#include "rimline/memory.h"

namespace rimline {

using namespace pipeline;

namespace {

// `last`: the last stage of the run.
void check(Points points, const Options& options, const Given& given, Stage last, const Run& run) {
  check_options(options);
  check_input(points, options, given);
  check_memory(points.size(), options, last, run);
}

}  // namespace

BoundaryResult find_boundary(Points points, const Options& options, const Run& run, const Given& given) {
  if (const auto scaled = scaled_to_unit(points, options, given, run))
    return run_scaled(find_boundary, *scaled, options, run);
  const Method& method = method_of(options.preset);
  check(points, options, given, Stage::Loops, run);
  StageClock clock;
  const PreparedPoints prepared = prepare(points, options, given, run, clock);               // Definition 2.1
  const BoundaryScores scores = score(prepared, options, run, clock);                        // eq. (1)
  const FoundLoops found = method.find_loops(prepared, scores, options, given, run, clock);  // eqs. (2), (3)
  clock.enter(Stage::Write);
  const Report report = report_boundary(prepared, scores, found, options, run);
  BoundaryResult result =
      boundary_of_input(prepared, scores, found, found.label, found.loops, options.loops, run);
  result.report = finish(report, result, run, clock);
  return result;
}

ParameterizeResult parameterize(Points points, const Options& options, const Run& run, const Given& given) {
  if (const auto scaled = scaled_to_unit(points, options, given, run))
    return run_scaled(parameterize, *scaled, options, run);
  const Method& method = method_of(options.preset);
  check(points, options, given, Stage::Refine, run);
  StageClock clock;
  const PreparedPoints prepared = prepare(points, options, given, run, clock);
  const BoundaryScores scores = score(prepared, options, run, clock);
  const FoundLoops found = method.find_loops(prepared, scores, options, given, run, clock);
  const MappedMesh map = method.map(prepared, found, options, given, run, clock);  // eq. (4)
  if (std::ranges::all_of(map.uv, [](UV p) { return std::isnan(p.u); }))
    throw Error(ErrorCode::NotADisc, "there is no map: no component is a disc with holes");
  clock.enter(Stage::Write);
  const Report report = add_map(report_boundary(prepared, scores, found, options, run), map);
  ParameterizeResult result;
  result.uv = uv_of_input(prepared, map.uv);
  result.uv.resize(points.size());  // new vertices of fills have no position among the points
  result.boundary = boundary_of_input(prepared, scores, found, map.label, map.loops, options.loops, run);
  result.boundary.report = finish(report, result.boundary, run, clock);
  return result;
}

ReconstructResult reconstruct(Points points, const Options& options, const Run& run, const Given& given) {
  if (const auto scaled = scaled_to_unit(points, options, given, run))
    return run_scaled(reconstruct, *scaled, options, run);
  const Method& method = method_of(options.preset);
  check(points, options, given, Stage::Measure, run);
  StageClock clock;
  const PreparedPoints prepared = prepare(points, options, given, run, clock);
  const BoundaryScores scores = score(prepared, options, run, clock);
  const FoundLoops found = method.find_loops(prepared, scores, options, given, run, clock);
  const MappedMesh mesh = method.mesh(prepared, found, options, given, run, clock);  // eq. (4), Delaunay
  if (const auto reason = why_no_mesh(mesh, options.mesh.strict)) {
    clock.enter(Stage::Write);
    Report report = add_map(report_boundary(prepared, scores, found, options, run), mesh);
    report.warnings.push_back(reason->what());
    BoundaryResult result =
        boundary_of_input(prepared, scores, found, found.label, found.loops, options.loops, run);
    result.report = finish(report, result, run, clock);
    throw NoMesh(*reason, std::move(result));
  }
  Measures measures = measure(prepared, mesh, given.reference, run, clock);
  clock.enter(Stage::Write);
  const Report on_boundary = report_boundary(prepared, scores, found, options, run);
  const Report report = add_measures(add_map(on_boundary, mesh), measures);
  ReconstructResult result;
  result.added = added_points(prepared, mesh);
  result.uv = uv_of_input(prepared, mesh.uv);
  result.triangles = triangles_of_input(prepared, mesh.triangles);
  result.seams = seams_of_input(prepared, mesh.seams);
  result.chart = mesh.chart;
  result.patch = patch_of_input(prepared, mesh.patch);
  result.filled.assign(mesh.filled.begin(), mesh.filled.end());
  result.distortion = distortion_of_input(prepared, std::move(measures.distortion));
  result.boundary = boundary_of_input(prepared, scores, found, mesh.label, mesh.loops, options.loops, run);
  result.boundary.report = finish(report, result.boundary, run, clock);
  return result;
}

}  // namespace rimline
