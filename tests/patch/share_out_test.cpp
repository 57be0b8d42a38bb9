// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/share_out.h"

#include <doctest/doctest.h>

namespace rimline {
namespace {

PatchInput patch_of(std::vector<Index> points) {
  PatchInput patch;
  patch.points = std::move(points);
  return patch;
}

}  // namespace

TEST_CASE("triangles go to the patch that has their corners, in its ids and in their order") {
  const std::vector<PatchInput> patches{patch_of({0, 2, 4, 6}), patch_of({1, 3, 5})};
  const auto parts = share_out({{1, 3, 5}, {4, 6, 2}, {0, 2, 4}}, 8, patches);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0] == std::vector<Triangle>{{2, 3, 1}, {0, 1, 2}});
  CHECK(parts[1] == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("a corner of two patches goes with the others") {
  const std::vector<PatchInput> patches{patch_of({0, 1, 4}), patch_of({2, 3, 4})};
  const auto parts = share_out({{0, 1, 4}, {4, 2, 3}}, 5, patches);
  CHECK(parts[0] == std::vector<Triangle>{{0, 1, 2}});
  CHECK(parts[1] == std::vector<Triangle>{{2, 0, 1}});
}

// Where the shared corner is higher than all ids of the patch, its place would be beyond its end; where it is
// lower, that of another point.
TEST_CASE("a triangle is left out where its patch has not all of its corners") {
  for (const Index between : {Index{0}, Index{3}, Index{9}}) {
    CAPTURE(between);
    const std::vector<PatchInput> patches{patch_of({1, 2, 5}), patch_of({between, 6, 7}),
                                          patch_of({between, 4, 8})};
    const auto parts = share_out({{1, 2, between}, {1, 2, 6}, {1, 2, 5}}, 10, patches);
    CHECK(parts[0] == std::vector<Triangle>{{0, 1, 2}});
    CHECK(parts[1].empty());
    CHECK(parts[2].empty());
  }
}

TEST_CASE("triangles of points that no patch has, or that only shared points span, are left out") {
  const std::vector<PatchInput> patches{patch_of({0, 1, 2, 3}), patch_of({1, 2, 3, 4})};
  const auto parts = share_out({{1, 2, 3}, {5, 6, 7}, {0, 1, 5}}, 8, patches);
  CHECK(parts[0].empty());
  CHECK(parts[1].empty());
}

}  // namespace rimline
