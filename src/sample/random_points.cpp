// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/random.h"
#include "sample/draft.h"
#include "sample/rim.h"

namespace rimline {

Draft random_points(const AnalyticSurface& surface, double spacing, std::size_t count, const Run& run) {
  const StepLength length = [&](UV a, UV b) { return distance(surface.at(a), surface.at(b)) / spacing; };
  const RimDistance rim(surface, length, spacing / 2, surface.at);
  const double largest = measure(surface, {}).largest_stretch;
  Random random(run.seed, 2);
  Draft draft;
  draft.points.reserve(count);
  draft.near.reserve(count);
  for (const auto& walked : walk_rims(surface, length, 1)) {
    auto& loop = draft.loops.emplace_back();
    for (const UV at : walked) {
      loop.push_back(static_cast<Index>(draft.points.size()));
      draft.points.push_back(surface.at(at));
      draft.near.push_back(1);
    }
  }
  for (std::size_t tries = 0; draft.points.size() < count; ++tries) {
    if (tries % 65536 == 0) run.progress(Stage::Arrange, draft.points.size(), count);
    const UV at{surface.box.low.u + surface.box.width() * random.uniform(),
                surface.box.low.v + surface.box.height() * random.uniform()};
    const double chance = random.uniform();
    if (surface.depth(at) <= 0 || chance * largest >= surface.tangents(at).area()) continue;
    draft.points.push_back(surface.at(at));
    draft.near.push_back(rim.within_half_spacing(at, spacing) ? 1 : 0);
  }
  return draft;
}

}  // namespace rimline
