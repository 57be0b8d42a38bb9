// SPDX-License-Identifier: GPL-3.0-or-later
// The method on one screen.
#include "rimline/pipeline.h"

#include "pipeline/find_loops.h"
#include "pipeline/input.h"
#include "pipeline/map_and_mesh.h"
#include "pipeline/measure.h"
#include "pipeline/results.h"
#include "rimline/memory.h"

namespace rimline {

using namespace pipeline;

namespace {

// The loops of the input: where all three ways begin. `last` is the stage that they end with.
Work with_loops(Points points, const Options& options, const Run& run, const Given& given, Stage last) {
  Work work{points, options, run, given};
  check_input(work);
  check_memory(points.size(), options, last, run);
  prepare(work);
  find_loops(work);
  return work;
}

}  // namespace

BoundaryResult find_boundary(Points points, const Options& options, const Run& run, const Given& given) {
  Work work = with_loops(points, options, run, given, Stage::Loops);
  work.clock.enter(Stage::Write);
  return boundary_result(work);
}

ParameterizeResult parameterize(Points points, const Options& options, const Run& run, const Given& given) {
  Work work = with_loops(points, options, run, given, Stage::Refine);
  work.is_paper() ? map_to_the_disc(work) : mesh_patches(work);
  work.clock.enter(Stage::Write);
  ParameterizeResult result;
  result.uv = uv_of_input(work);
  result.uv.resize(points.size());  // vertices that fills added have no place among the points
  result.boundary = boundary_result(work);
  return result;
}

ReconstructResult reconstruct(Points points, const Options& options, const Run& run, const Given& given) {
  Work work = with_loops(points, options, run, given, Stage::Measure);
  if (work.is_paper()) {
    map_to_the_disc(work);
    triangulate_the_disc(work);
  } else {
    mesh_patches(work);
  }
  measure(work);
  work.clock.enter(Stage::Write);
  ReconstructResult result;
  result.uv = uv_of_input(work);
  result.added = added_points(work);
  result.triangles = triangles_of_input(work);
  result.filled.assign(work.filled.begin(), work.filled.end());
  result.distortion = distortion_of_input(work);
  result.patch = patch_of_input(work);
  result.boundary = boundary_result(work);
  return result;
}

}  // namespace rimline
