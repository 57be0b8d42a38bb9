// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/sampling_profile.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "base/random.h"
#include "rimline/sample.h"

using namespace rimline;

namespace {

std::vector<Point> make(Sampling sampling, double noise) {
  SampleOptions options;
  options.shape = Shape::WavySaddle;
  options.sampling = sampling;
  options.n = 9000;
  options.noise = noise;
  return sample(options, {}).points;
}

// The ids of the points in each of `count` slabs along x.
std::vector<std::vector<Index>> slabs(const std::vector<Point>& points, int count) {
  std::vector<std::vector<Index>> parts(count);
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
    parts[std::clamp(static_cast<int>((points[i].x + 1) / 2 * count), 0, count - 1)].push_back(i);
  return parts;
}

}  // namespace

TEST_CASE("samples of slabs add up to that of the whole, in any order, and give the same profile") {
  for (const Sampling sampling : {Sampling::BlueNoise, Sampling::Random, Sampling::ScanLines}) {
    for (const double noise : {0.0, 0.3}) {
      const std::vector<Point> points = make(sampling, noise);
      const Neighbours neighbours = find_neighbours(points, 40, {});
      const std::vector<double> spacing = local_spacing(points, neighbours, {});
      std::vector<SamplingSample> parts;
      for (const auto& slab : slabs(points, 4)) {
        REQUIRE(!slab.empty());
        parts.push_back(sample_sampling(points, slab, neighbours, spacing, {}));
      }
      const SamplingProfile whole = profile_sampling(points, neighbours, spacing, {});
      for (int round = 0; round < 2; ++round) {
        SamplingSample sum = parts[0];
        for (std::size_t i = 1; i < parts.size(); ++i) sum += parts[i];
        const SamplingProfile added = profile_of(sum);
        CHECK(added.noise.noise == whole.noise.noise);
        CHECK(added.noise.irregular == whole.noise.irregular);
        CHECK(added.noise.anisotropic == whole.noise.anisotropic);
        CHECK(added.noise_weight == whole.noise_weight);
        std::reverse(parts.begin(), parts.end());
      }
      CHECK((whole.noise.noise > 0) == (noise > 0));
      CHECK(whole.is_random() == (sampling == Sampling::Random));
    }
  }
}

TEST_CASE("a sample is of the points alone: not of their order, nor of the threads") {
  std::vector<Point> points = make(Sampling::Random, 0);
  const auto places = [](const std::vector<Point>& from, const std::vector<Index>& ids) {
    std::vector<double> x;
    for (const Index id : ids) x.push_back(from[id].x);
    return x;
  };
  const std::vector<double> chosen = places(points, choose_sample(points, 500, {}));
  CHECK(chosen.size() == 500);
  Random(3).shuffle(points);
  Run run;
  run.threads = 1;
  CHECK(places(points, choose_sample(points, 500, run)) == chosen);
}

TEST_CASE("a sample takes all points of a few, each once, and spreads over many") {
  const std::vector<Point> points = make(Sampling::BlueNoise, 0);
  const std::vector<Index> all = choose_sample(points, points.size() + 7, {});
  CHECK(std::set<Index>(all.begin(), all.end()).size() == points.size());
  int left = 0;
  for (const Index id : choose_sample(points, 1000, {})) left += points[id].x < 0;
  CHECK(left > 400);
  CHECK(left < 600);
  CHECK(choose_sample({}, 10, {}).empty());
}
