// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds of at most 60 points: reconstruct gives a result whose ids are those of the cloud, or says why not.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "rimline/pipeline.h"

namespace {

using namespace rimline;

constexpr std::size_t most_points = 60;

// The bytes of an input one after the other; zeros after its end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool done() const { return at_ >= size_; }
  int next() { return done() ? 0 : data_[at_++]; }
  double signed_byte() { return static_cast<std::int8_t>(next()); }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

Options options_from(Bytes& bytes) {
  constexpr Preset presets[] = {Preset::Default, Preset::Default, Preset::Paper, Preset::PaperLog};
  constexpr Domain domains[] = {Domain::Disc, Domain::Square, Domain::Rectangle, Domain::Free};
  const int choice = bytes.next();
  Options options = preset_options(presets[choice & 3]);
  if (options.preset != Preset::Default) return options;
  options.map.domain = domains[(choice >> 2) & 3];
  options.mesh.holes.fill = choice & 16;
  options.mesh.fill_points = choice & 32;
  options.mesh.strict = choice & 64;
  return options;
}

// On a lattice, so that ties and coinciding points are common; the second byte chooses the scale.
std::vector<Point> points_from(Bytes& bytes) {
  const double unit = std::ldexp(1.0, static_cast<int>(8 * bytes.signed_byte()));
  std::vector<Point> points;
  while (!bytes.done() && points.size() < most_points) {
    const double x = bytes.signed_byte(), y = bytes.signed_byte(), z = bytes.signed_byte();
    points.push_back(unit * Point{x, y, z});
  }
  return points;
}

void check_ids(const ReconstructResult& result, std::size_t points) {
  const auto most = static_cast<Index>(points + result.added.size());
  for (const Triangle& t : result.triangles) {
    for (const Index id : t) {
      if (id < 0 || id >= most) std::abort();
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) std::abort();
  }
  for (const Loop& loop : result.boundary.loops) {
    for (const Index id : loop.points) {
      if (id < 0 || id >= static_cast<Index>(points)) std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const Options options = options_from(bytes);
  const std::vector<Point> points = points_from(bytes);
  Run run;
  run.threads = 1;
  try {
    check_ids(reconstruct(points, options, run), points.size());
  } catch (const Error&) {
  }
  return 0;
}
