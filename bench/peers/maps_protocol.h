// SPDX-License-Identifier: GPL-3.0-or-later
// How somebody is asked for a map: PROGRAM METHOD IN OUT. Both files are plain arrays in native order.
//   IN   count (int64), then x y z (3 doubles) a point;
//        count (int64), then three ids (3 int32) a triangle
//   OUT  seconds of CPU that the method took on one thread (double): a machine that does other work is no
//   slower by them;
//        count (int64), then u v of each corner (6 doubles) a triangle;
//        count (int64), then the chart (int32) of a triangle
// Status 0, or another and the reason on standard error.
#pragma once

#include <ctime>

#include "peers/protocol.h"

namespace rimline::peers {

struct MeshToMap {
  Coordinates points;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

struct MapAnswer {
  std::vector<std::array<double, 6>> corners;
  std::vector<std::int32_t> chart;
};

// A method is timed by itself: it makes its own kind of mesh first, and starts the clock.
class Clock {
 public:
  void start() { start_ = std::clock(); }
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

// The main() of one that maps. Its time is from the clock's start to its return.
using MapMethod = std::function<MapAnswer(const MeshToMap&, Clock&)>;
inline int serve_maps(int argc, char** argv, const std::map<std::string, MapMethod>& methods) try {
  if (!is_known_method(argc, argv, methods)) return 1;
  std::ifstream in(argv[2], std::ios::binary);
  MeshToMap mesh;
  mesh.points = read_array<std::array<double, 3>>(in);
  mesh.triangles = read_array<std::array<std::int32_t, 3>>(in);
  Clock clock;
  const MapAnswer answer = methods.at(argv[1])(mesh, clock);
  const double seconds = clock.seconds();
  std::ofstream out(argv[3], std::ios::binary);
  out.write(reinterpret_cast<const char*>(&seconds), sizeof seconds);
  write_array(out, answer.corners);
  write_array(out, answer.chart);
  if (!out.flush()) throw std::runtime_error("can not write the map");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}

}  // namespace rimline::peers
