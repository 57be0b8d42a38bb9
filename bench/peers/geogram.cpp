// SPDX-License-Identifier: GPL-3.0-or-later
// geogram's Co3Ne (Levy; concurrent co-cones): as its command line runs it, and within five spacings without
// filling holes.
#include <geogram/basic/command_line.h>
#include <geogram/basic/command_line_args.h>
#include <geogram/basic/common.h>
#include <geogram/basic/geometry.h>
#include <geogram/basic/logger.h>
#include <geogram/basic/process.h>
#include <geogram/mesh/mesh.h>
#include <geogram/mesh/mesh_geometry.h>
#include <geogram/points/co3ne.h>
#include <geogram/points/nn_search.h>

#include <cmath>

#include "peers/protocol.h"

namespace rimline::peers {
namespace {

constexpr GEO::index_t normal_k = 30;  // co3ne:nb_neighbors of the command line

void load(const Coordinates& points, GEO::Mesh& mesh) {
  mesh.vertices.set_dimension(3);
  mesh.vertices.create_vertices(static_cast<GEO::index_t>(points.size()));
  for (GEO::index_t i = 0; i < mesh.vertices.nb(); ++i) {
    for (int c = 0; c < 3; ++c) mesh.vertices.point_ptr(i)[c] = points[i][c];
  }
}

double mean_spacing(const GEO::Mesh& mesh) {
  const GEO::NearestNeighborSearch_var search = GEO::NearestNeighborSearch::create(3);
  search->set_points(mesh.vertices.nb(), mesh.vertices.point_ptr(0));
  double sum = 0;
  for (GEO::index_t i = 0; i < mesh.vertices.nb(); ++i) {
    GEO::index_t ids[7];
    double squared[7];
    search->get_nearest_neighbors(7, mesh.vertices.point_ptr(i), ids, squared);
    for (const double d : squared) sum += std::sqrt(d) / 6;
  }
  return sum / static_cast<double>(mesh.vertices.nb());
}

// Repair may drop and renumber vertices, but it moves none: they are found again by their coordinates.
Answer triangles_of(const GEO::Mesh& mesh, const Coordinates& points) {
  std::map<std::array<double, 3>, std::int32_t> id_of;
  for (std::size_t i = 0; i < points.size(); ++i) id_of.emplace(points[i], static_cast<std::int32_t>(i));
  Answer answer;
  for (GEO::index_t f = 0; f < mesh.facets.nb(); ++f) {
    auto& triangle = answer.triangles.emplace_back();
    for (GEO::index_t c = 0; c < 3; ++c) {
      const double* p = mesh.vertices.point_ptr(mesh.facets.vertex(f, c));
      triangle[c] = id_of.at({p[0], p[1], p[2]});
    }
  }
  return answer;
}

Answer as_command_line(const Coordinates& points) {
  GEO::Mesh mesh;
  load(points, mesh);
  const double radius = 0.05 * GEO::bbox_diagonal(mesh);  // co3ne:radius = 5%
  GEO::Co3Ne_smooth_and_reconstruct(mesh, normal_k, 0, radius);
  return triangles_of(mesh, points);
}

Answer on_all_cores(const Coordinates& points) {
  GEO::Process::enable_multithreading(true);
  return as_command_line(points);
}

Answer without_filling(const Coordinates& points) {
  GEO::CmdLine::set_arg("co3ne:max_hole_edges", "0");
  GEO::CmdLine::set_arg("co3ne:max_hole_area", "0");
  GEO::Mesh mesh;
  load(points, mesh);
  GEO::Co3Ne_smooth_and_reconstruct(mesh, normal_k, 0, 5 * mean_spacing(mesh));
  return triangles_of(mesh, points);
}

}  // namespace
}  // namespace rimline::peers

int main(int argc, char** argv) {
  using namespace rimline::peers;
  GEO::initialize(GEO::GEOGRAM_INSTALL_NONE);
  GEO::Logger::instance()->set_quiet(true);
  GEO::CmdLine::import_arg_group("standard");
  GEO::CmdLine::import_arg_group("algo");
  GEO::CmdLine::import_arg_group("co3ne");
  GEO::CmdLine::set_arg("sys:multithread", "false");
  return serve(
      argc, argv,
      {{"co3ne", as_command_line}, {"co3ne-parallel", on_all_cores}, {"co3ne-no-fill", without_filling}});
}
