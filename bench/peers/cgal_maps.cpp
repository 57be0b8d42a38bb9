// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's Surface_mesh_parameterization: free borders (LSCM, ARAP) and the circle (discrete
// conformal, discrete authalic).
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include "peers/maps_protocol.h"

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace maps = CGAL::Surface_mesh_parameterization;

Mesh mesh_of(const rimline::peers::MeshToMap& given) {
  Mesh mesh;
  for (const auto& p : given.points) mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& t : given.triangles) {
    const auto v = [&](int c) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(t[c])); };
    if (mesh.add_face(v(0), v(1), v(2)) == Mesh::null_face()) throw std::runtime_error("no manifold");
  }
  return mesh;
}

template <class Parameterizer>
rimline::peers::MapAnswer map_by(const rimline::peers::MeshToMap& given, rimline::peers::Clock& clock) {
  Mesh mesh = mesh_of(given);
  clock.start();
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const maps::Error_code error = maps::parameterize(mesh, Parameterizer(), border, uv);
  if (error != maps::OK) throw std::runtime_error(maps::get_error_message(error));
  rimline::peers::MapAnswer answer;
  for (const auto& t : given.triangles) {
    auto& corners = answer.corners.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const auto& at = uv[Mesh::Vertex_index(static_cast<Mesh::size_type>(t[c]))];
      corners[2 * c] = at.x(), corners[2 * c + 1] = at.y();
    }
  }
  answer.chart.assign(given.triangles.size(), 0);
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  return rimline::peers::serve_maps(
      argc, argv,
      {{"lscm", map_by<maps::LSCM_parameterizer_3<Mesh>>},
       {"arap", map_by<maps::ARAP_parameterizer_3<Mesh>>},
       {"discrete-authalic", map_by<maps::Discrete_authalic_parameterizer_3<Mesh>>},
       {"discrete-conformal", map_by<maps::Discrete_conformal_map_parameterizer_3<Mesh>>}});
}
