// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/notch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "exact/jaggedness.h"
#include "exact/odds.h"

namespace rimline::exact {
namespace {

struct Notch {
  double log_odds;
  Index triangle, behind;
};

}  // namespace

std::vector<Index> open_notches(const Complex& complex, LocalSizes& sizes, const UsualCorners& usual,
                                const std::vector<std::vector<Index>>& rims, Kept& kept) {
  std::vector<std::uint8_t> on_rim(complex.vertices(), 0);
  for (const auto& rim : rims) {
    for (const Index v : rim) on_rim[v] = 1;
  }
  std::vector<Notch> notches;
  for (const auto& rim : rims) {
    const std::vector<double> jagged = jaggedness(complex.points(), rim);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Index a = rim[i], b = rim[i + 1 < rim.size() ? i + 1 : 0];
      if (jagged[i] == 0) continue;
      const Index t = kept_triangle(complex, kept, a, b);
      const Index behind = complex.apex(t, a, b);
      if (on_rim[behind]) continue;
      const double odds = jagged_log_odds(complex, sizes, usual, {a, behind, b}, jagged[i]);
      if (odds > 0) notches.push_back({odds, t, behind});
    }
  }
  std::sort(notches.begin(), notches.end(), [](const Notch& a, const Notch& b) {
    return std::tuple(-a.log_odds, a.triangle) < std::tuple(-b.log_odds, b.triangle);
  });
  std::vector<Index> opened;
  for (const Notch& notch : notches) {
    if (on_rim[notch.behind]) continue;  // a second one would pinch the rim there
    on_rim[notch.behind] = 1;
    kept[notch.triangle] = 0;
    opened.push_back(notch.behind);
  }
  return opened;
}

}  // namespace rimline::exact
