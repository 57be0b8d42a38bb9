// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/select.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/random.h"

namespace rimline {
namespace {

TEST_CASE("what is selected is what sorting puts there, with the lesser before and the greater behind") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Random random(4);
  for (const int kinds : {1, 2, 9, 1000000}) {  // of values, so that many are equal
    for (const int count : {1, 2, 15, 40, 1000}) {
      std::vector<double> values(count);
      for (double& v : values) v = std::floor(random.uniform() * kinds);
      if (count > 100) values[3] = values[5] = infinity, values[8] = -infinity;
      for (int run = 0; run < 3; ++run) {  // any order, ascending, descending
        for (const int nth : {0, count / 3, count / 2, count - 1}) {
          std::vector<double> items = values, sorted = values;
          std::sort(sorted.begin(), sorted.end());
          select(items.data(), items.data() + nth, items.data() + count, [](double v) { return v; });
          CHECK(items[nth] == sorted[nth]);
          for (int i = 0; i < count; ++i) CHECK((i < nth ? items[i] <= items[nth] : items[i] >= items[nth]));
          std::sort(items.begin(), items.end());
          CHECK(items == sorted);
        }
        std::sort(values.begin(), values.end());
        if (run == 1) std::reverse(values.begin(), values.end());
      }
    }
  }
}

}  // namespace
}  // namespace rimline
