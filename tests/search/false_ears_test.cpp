// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/false_ears.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "surface/propose.h"

using namespace rimline;

namespace {

// A disc of a hexagonal lattice, each point moved by up to a fifth of the step, or one whose rim is an even
// circle.
std::vector<Point> disc(bool is_cut) {
  Random random(4);
  std::vector<Point> points;
  for (int i = -30; i <= 30; ++i) {
    for (int j = -34; j <= 34; ++j) {
      const Point p{i + 0.5 * (j & 1) + 0.2 * (2 * random.uniform() - 1),
                    j * std::sqrt(0.75) + 0.2 * (2 * random.uniform() - 1), 0};
      if (norm(p) < (is_cut ? 24 : 23.3)) points.push_back(p);
    }
  }
  for (int i = 0; !is_cut && i < 150; ++i) {
    const double turn = 6.283185307179586 * i / 150;
    points.push_back({24 * std::cos(turn), 24 * std::sin(turn), 0});
  }
  return points;
}

struct Found {
  std::size_t before, after;  // selected triangles
  std::vector<std::uint8_t> behind;
};

Found find(const std::vector<Point>& points, const SamplingProfile& sampling) {
  const Run run;
  BoundaryLoopOptions options;
  const Neighbours neighbours = find_neighbours(points, 40, run);
  const std::vector<double> spacing = local_spacing(points, neighbours, run);
  const Samples samples = with_frames(points, neighbours, spacing, run);
  const SelectedSurface surface = select(propose_surface(samples, run), samples, sampling, options, run);
  const LocalSizes sizes(surface.set, neighbours, run);
  const WithoutFalseEars without = remove_false_ears(surface, sizes, samples, sampling, options, run);
  for (std::size_t t = 0; t < surface.selection.size(); ++t)
    CHECK(without.selection[t] <= surface.selection[t]);
  const auto count = [](const Selection& s) {
    return static_cast<std::size_t>(std::count(s.begin(), s.end(), 1));
  };
  return {count(surface.selection), count(without.selection), without.behind};
}

}  // namespace

TEST_CASE("a cut surface loses ears, one for each point that comes to its rim, an even one next to none") {
  const Found cut = find(disc(true), {}), even = find(disc(false), {});
  CHECK(cut.before - cut.after >= 3);
  CHECK(std::count(cut.behind.begin(), cut.behind.end(), 1) ==
        static_cast<std::ptrdiff_t>(cut.before - cut.after));
  CHECK(even.before - even.after < (cut.before - cut.after) / 3 + 1);
}

TEST_CASE("under noise, among random points and in range images no ear is removed") {
  SamplingProfile noisy, random;
  noisy.noise.noise = 0.2;
  random.noise.irregular = 1;
  for (const SamplingProfile& sampling : {noisy, random, of_range_image()}) {
    const Found found = find(disc(true), sampling);
    CHECK(found.before == found.after);
    CHECK(found.behind.empty());
  }
}
