// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/compaction.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/random.h"

namespace rimline {
namespace {

TEST_CASE("items are kept as a loop keeps them, for any number of threads") {
  for (const std::size_t count : {0, 1, 1000, 16384, 100001}) {
    std::vector<int> items(count);
    std::iota(items.begin(), items.end(), 7);
    for (const std::uint64_t one_in : {1, 2, 50, 1000000}) {  // is left out
      Random random(one_in, count);
      std::vector<std::uint8_t> kept(count);
      for (std::uint8_t& k : kept) k = random.below(one_in) != 0;
      std::vector<int> expected;
      std::vector<Index> places;
      for (std::size_t i = 0; i < count; ++i) {
        places.push_back(kept[i] ? static_cast<Index>(expected.size()) : none);
        if (kept[i]) expected.push_back(items[i]);
      }
      for (const int threads : {1, 4}) {
        CAPTURE(count);
        CAPTURE(one_in);
        CAPTURE(threads);
        Run run;
        run.threads = threads;
        const KeptItems items_kept(kept, Stage::Loops, run);
        CHECK(items_kept.size() == expected.size());
        CHECK(items_kept.is_all() == (expected.size() == count));
        CHECK(items_kept.of(items) == expected);
        CHECK(std::ranges::equal(items_kept.places(), places));
      }
    }
  }
}

}  // namespace
}  // namespace rimline
