// SPDX-License-Identifier: GPL-3.0-or-later
#include "local/point_sample.h"

#include <bit>

#include "base/parallel.h"
#include "base/random.h"

namespace rimline {

SampleKey sample_key(Point p) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // no negative zero
  return {Random(Random(bits(p.x), bits(p.y)).next(), bits(p.z)).next(), p};
}

std::vector<Index> choose_sample(Points points, std::size_t most, const Run& run) {
  // Nearly always twice as many points as wanted have a hash below this bound; all points are taken where
  // they do not.
  constexpr double all = 0x1p64;  // [layout]
  const double share = 2.0 * static_cast<double>(most) / static_cast<double>(points.size());
  const auto below = [&](double bound) {
    return parallel_gather<std::pair<SampleKey, Index>>(
        points.size(), Stage::Survey, run, [&](Index i, std::vector<std::pair<SampleKey, Index>>& found) {
          const SampleKey key = sample_key(points[i]);
          if (static_cast<double>(key.hash) < bound) found.push_back({key, i});
        });
  };
  auto chosen = below(share < 1 ? share * all : 2 * all);
  if (chosen.size() < std::min(most, points.size())) chosen = below(2 * all);
  std::sort(chosen.begin(), chosen.end(), [](const auto& a, const auto& b) {
    return a.first < b.first || (!(b.first < a.first) && a.second < b.second);
  });
  chosen.resize(std::min(most, chosen.size()));
  std::vector<Index> ids;
  for (const auto& [key, id] : chosen) ids.push_back(id);
  return ids;
}

}  // namespace rimline
