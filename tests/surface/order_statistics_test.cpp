// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/order_statistics.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "base/random.h"

using namespace rimline;

TEST_CASE("values at ranks are those of sorting, for spread out, tied, tiny, huge and infinite values") {
  Random random(1);
  const std::vector<double> odd{0.0, 5e-324, 1e-300, 1, 1, 1, 1e300, std::numeric_limits<double>::infinity()};
  for (int round = 0; round < 2000; ++round) {
    std::vector<double> values(1 + random.below(round % 10 == 0 ? 600 : 120));
    for (double& v : values) {
      v = round % 3 == 0   ? odd[random.below(odd.size())]
          : round % 3 == 1 ? random.uniform()
                           : 1 + 1e-12 * random.uniform();
    }
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t n = values.size();
    const auto found = at_ranks(values, {n / 4, 5 * n / 8, 3 * n / 4});
    REQUIRE(found[0] == sorted[n / 4]);
    REQUIRE(found[1] == sorted[5 * n / 8]);
    REQUIRE(found[2] == sorted[3 * n / 4]);
  }
}
