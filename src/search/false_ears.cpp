// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/false_ears.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "evidence/jaggedness.h"
#include "evidence/probability.h"

namespace rimline {
namespace {

struct Ear {
  double log_odds;
  Index triangle, behind;
};

}  // namespace

std::vector<Index> remove_false_ears(const TriangleSet& set, LocalSizes& sizes, const CornerHistogram& usual,
                                     const std::vector<std::vector<Index>>& rims, Selection& selected) {
  std::vector<std::uint8_t> on_rim(set.vertices(), 0);
  for (const auto& rim : rims) {
    for (const Index v : rim) on_rim[v] = 1;
  }
  std::vector<Ear> ears;
  for (const auto& rim : rims) {
    const std::vector<double> jagged = jaggedness(set.points(), rim);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Index a = rim[i], b = rim[i + 1 < rim.size() ? i + 1 : 0];
      if (jagged[i] == 0) continue;
      const Index t = selected_triangle(set, selected, a, b);
      const Index behind = set.apex(t, a, b);
      if (on_rim[behind]) continue;
      const double odds = false_ear_log_odds(set, sizes, usual, {a, behind, b}, jagged[i]);
      if (odds > 0) ears.push_back({odds, t, behind});
    }
  }
  std::sort(ears.begin(), ears.end(), [](const Ear& a, const Ear& b) {
    return std::tuple(-a.log_odds, a.triangle) < std::tuple(-b.log_odds, b.triangle);
  });
  std::vector<Index> opened;
  for (const Ear& ear : ears) {
    if (on_rim[ear.behind]) continue;  // a second one would pinch the rim there
    on_rim[ear.behind] = 1;
    selected[ear.triangle] = 0;
    opened.push_back(ear.behind);
  }
  return opened;
}

}  // namespace rimline
