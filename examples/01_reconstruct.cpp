// SPDX-License-Identifier: GPL-3.0-or-later
// One call: from a file with points to a file with a mesh.
//   01_reconstruct [IN.ply [OUT.ply]]
// Without arguments it takes a sample of its own.
#include <rimline/io.h>
#include <rimline/pipeline.h>
#include <rimline/sample.h>

#include <cstdio>

namespace {

rimline::Cloud sample_cloud(const rimline::Run& run) {
  rimline::Cloud cloud;
  cloud.points = rimline::sample({.shape = rimline::Shape::HalfTunnel, .n = 2000}, run).points;
  return cloud;
}

}  // namespace

int main(int count, char** arguments) {
  const rimline::Run run{.seed = 7};
  try {
    rimline::Cloud cloud = count > 1 ? rimline::read_cloud(arguments[1], run) : sample_cloud(run);
    const auto options = rimline::preset_options(rimline::Preset::Default);
    const rimline::ReconstructResult result = rimline::reconstruct(cloud.points, options, run);
    rimline::write_mesh(count > 2 ? arguments[2] : "mesh.ply", cloud, result.triangles, run);
    std::printf("%zu points, %zu loops, %zu triangles\n", cloud.points.size(), result.boundary.loops.size(),
                result.triangles.size());
    return result.triangles.empty() ? 1 : 0;
  } catch (const rimline::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return rimline::exit_status(error.code());
  }
}
