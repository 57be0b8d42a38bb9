// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/false_ears.h"

#include <algorithm>
#include <utility>

#include "base/model.h"
#include "base/vec.h"
#include "evidence/jaggedness.h"
#include "evidence/probability.h"
#include "evidence/rim_probability.h"
#include "surface/triangle_order.h"

namespace rimline {
namespace {

using Rims = std::vector<std::vector<Index>>;

struct Ear {
  double log_odds;
  Index triangle, behind;
};

// One layer of the rims' false ears, the likeliest first.
std::vector<Ear> find_false_ears(const TriangleSet& set, const Selection& selection, const LocalSizes& sizes,
                                 const CornerHistogram& corners, const Rims& rims) {
  std::vector<std::uint8_t> on_rim(set.vertices(), 0);
  for (const auto& rim : rims) {
    for (const Index v : rim) on_rim[v] = 1;
  }
  std::vector<Ear> ears;
  for (const auto& rim : rims) {
    const std::vector<double> jagged = jaggedness(set.points(), rim);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Index a = rim[i], b = rim[next_in(i, rim.size())];
      if (jagged[i] == 0) continue;
      const Index t = selected_triangle(set, selection, a, b);
      const Index behind = set.apex(t, a, b);
      if (on_rim[behind]) continue;
      const double odds =
          false_ear_log_odds(measure_false_ear(set, sizes, corners, {a, behind, b}, jagged[i]));
      if (odds > 0) ears.push_back({odds, t, behind});
    }
  }
  std::sort(ears.begin(), ears.end(),
            [&, is_before = TriangleOrder(set.points())](const Ear& a, const Ear& b) {
              return a.log_odds != b.log_odds ? a.log_odds > b.log_odds
                                              : is_before(set.triangle(a.triangle), set.triangle(b.triangle));
            });
  // A second ear with the same third corner would pinch the rim there.
  std::erase_if(ears, [&](const Ear& ear) { return std::exchange(on_rim[ear.behind], 1) != 0; });
  return ears;
}

}  // namespace

WithoutFalseEars remove_false_ears(const SelectedSurface& surface, const LocalSizes& sizes,
                                   const Samples& samples, const SamplingProfile& sampling,
                                   const BoundaryLoopOptions& options, const Run& run) {
  WithoutFalseEars result{surface.selection, {}, {}};
  if (sampling.is_range_image || sampling.noise.noise > 0 || sampling.is_random())
    return result;
  const auto boundary_rims = [&] {
    const RimEvidence evidence{surface.set, result.selection, result.behind, samples, sampling};
    Rims rims = walk_rims(surface.set, result.selection, run);
    std::erase_if(rims, [&](const auto& rim) {
      return static_cast<int>(rim.size()) < options.min_loop ||
             boundary_probability(rim, evidence, run) < options.min_probability;
    });
    return rims;
  };
  result.behind.assign(samples.points.size(), 0);
  Rims rims = boundary_rims();
  result.corners = CornerHistogram(surface.set, sizes, samples.neighbours, rims, result.selection);
  // The jaggedness of the rim is known only after the first ears, and those behind them, are removed.
  for (int layer = 1;; ++layer) {
    const std::vector<Ear> ears = find_false_ears(surface.set, result.selection, sizes, result.corners, rims);
    for (const Ear& ear : ears) {
      result.selection[ear.triangle] = 0;
      result.behind[ear.behind] = 1;
    }
    if (ears.empty() || layer == model::false_ear_layers) return result;
    rims = boundary_rims();
  }
}

}  // namespace rimline
