// SPDX-License-Identifier: GPL-3.0-or-later
// A boundary of your own: found by rimline and corrected, or made by another program. The mesh ends at it.
#include <rimline/pipeline.h>
#include <rimline/sample.h>

#include <cstdio>

using namespace rimline;

int main() {
  const Run run{.seed = 7};
  const Options options = preset_options(Preset::Default);
  const Sample square = sample({.shape = Shape::SquareWithHoles, .n = 4000}, run);

  // The true loops of the sample play the part of a boundary made by hand. Of each loop only `points` is
  // read: ids of the input, in order, the surface on their left.
  Given given;
  given.loops = square.loops;
  const ReconstructResult result = reconstruct(square.points, options, run, given);

  const MeshSummary& mesh = result.boundary.report.mesh;
  std::printf("%zu loops given, the mesh has %zu boundary loops and Euler number %lld\n", given.loops.size(),
              mesh.boundary_loops, mesh.euler);

  // Loops that do not fit are refused with the ids that are the reason.
  given.loops[0].points.push_back(static_cast<Index>(square.points.size()));
  try {
    reconstruct(square.points, options, run, given);
  } catch (const Error& error) {
    std::printf("refused: %s (%zu ids)\n", error.what(), error.ids().size());
    return mesh.boundary_loops == square.loops.size() ? 0 : 1;
  }
  return 1;
}
