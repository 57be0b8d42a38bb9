// SPDX-License-Identifier: GPL-3.0-or-later
// rimline's maps of a mesh that is given, asked as the others are.
#include "map/free_chart.h"
#include "map/open_mesh.h"
#include "peers/maps_protocol.h"
#include "rimline/map_by_charts.h"

namespace {

using rimline::Index;

struct Given {
  std::vector<rimline::Point> points;
  std::vector<rimline::Triangle> triangles;
};

Given given_of(const rimline::peers::MeshToMap& mesh) {
  Given given;
  for (const auto& p : mesh.points) given.points.push_back({p[0], p[1], p[2]});
  for (const auto& t : mesh.triangles) given.triangles.push_back({t[0], t[1], t[2]});
  return given;
}

const rimline::Run one_thread{.threads = 1};

rimline::peers::MapAnswer by_charts(const rimline::peers::MeshToMap& mesh, rimline::peers::Clock& clock,
                                    int charts) {
  const Given given = given_of(mesh);
  clock.start();
  const rimline::ChartedMap map =
      rimline::map_by_charts(given.points, given.triangles, {.charts = charts}, one_thread);
  if (map.charts == 0) throw std::runtime_error("no map");
  if (charts == 1 && map.kind != rimline::Domain::Free)
    throw std::runtime_error("no free map, the disc's is given");
  rimline::peers::MapAnswer answer;
  for (const auto& t : map.corners) {
    const auto [a, b, c] = std::array{map.uv[t[0]], map.uv[t[1]], map.uv[t[2]]};
    answer.corners.push_back({a.u, a.v, b.u, b.v, c.u, c.v});
  }
  answer.chart.assign(map.chart.begin(), map.chart.end());
  return answer;
}

rimline::peers::MapAnswer to_disc(const rimline::peers::MeshToMap& mesh, rimline::peers::Clock& clock) {
  const Given given = given_of(mesh);
  clock.start();
  const rimline::OpenMesh open = rimline::open_surface(given.points, given.triangles);
  const auto map = rimline::disc_chart(open, rimline::ChartOptions{}.residual, one_thread);
  if (!map) throw std::runtime_error("no map to the disc");
  rimline::peers::MapAnswer answer;
  answer.corners.resize(given.triangles.size());
  for (std::size_t i = 0; i < open.triangle.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const Index v = open.mesh.triangles[i][c];
      const auto& t = given.triangles[open.triangle[i]];
      const auto corner = 2 * (std::find(t.begin(), t.end(), open.vertex[v]) - t.begin());
      answer.corners[open.triangle[i]][corner] = map->uv[v].u;
      answer.corners[open.triangle[i]][corner + 1] = map->uv[v].v;
    }
  }
  answer.chart.assign(given.triangles.size(), 0);
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rimline::peers;
  return serve_maps(argc, argv,
                    {{"auto", [](const MeshToMap& mesh, Clock& clock) { return by_charts(mesh, clock, 0); }},
                     {"one", [](const MeshToMap& mesh, Clock& clock) { return by_charts(mesh, clock, 1); }},
                     {"disc", to_disc}});
}
