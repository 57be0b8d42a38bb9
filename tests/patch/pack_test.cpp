// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/pack.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace rimline {

TEST_CASE(
    "boxes of any size are packed without overlap, the one of most vertices where it was, and not in one "
    "long row") {
  Random random(5);
  constexpr std::size_t count = 30;
  std::vector<Index> patch;
  std::vector<UV> uv;
  for (Index p = 0; p < static_cast<Index>(count); ++p) {
    const double width = 0.1 + random.uniform(), height = 0.1 + random.uniform();
    for (const UV corner : {UV{-width, -height}, {width, -height}, {width, height}, {-width, height}}) {
      uv.push_back(corner);
      patch.push_back(p);
    }
  }
  uv.push_back({0, 0});  // the first has most
  patch.push_back(0);
  uv.push_back({7, 7});  // of no patch
  patch.push_back(none);
  const std::vector<UV> before = uv;
  pack_patches(patch, count, uv);
  for (int corner = 0; corner < 4; ++corner) CHECK(uv[corner] == before[corner]);
  CHECK(uv.back() == before.back());
  double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const UV a = uv[4 * i], b = uv[4 * i + 2], c = uv[4 * j], d = uv[4 * j + 2];
      CHECK((b.u < c.u || d.u < a.u || b.v < c.v || d.v < a.v));
    }
    left = std::min(left, uv[4 * i].u), right = std::max(right, uv[4 * i + 2].u);
    low = std::min(low, uv[4 * i].v), high = std::max(high, uv[4 * i + 2].v);
  }
  CHECK((right - left) / (high - low) < 4);
}

TEST_CASE("small boxes are as far apart as is asked for") {
  constexpr std::size_t count = 40;
  constexpr double least = 0.05;
  std::vector<Index> patch;
  std::vector<UV> uv;
  for (Index p = 0; p < static_cast<Index>(count); ++p) {
    const double size = p == 0 ? 1 : 0.01;
    for (const UV corner : {UV{0, 0}, {size, 0}, {size, size}, {0, size}}) {
      uv.push_back(corner);
      patch.push_back(p);
    }
  }
  const double side = std::sqrt(1 + (count - 1) * 0.01 * 0.01);
  pack_patches(patch, count, uv, least);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const UV a = uv[4 * i], b = uv[4 * i + 2], c = uv[4 * j], d = uv[4 * j + 2];
      const double gap = std::max({c.u - b.u, a.u - d.u, c.v - b.v, a.v - d.v});
      CHECK(gap > 0.999 * least * side);
    }
  }
}

}  // namespace rimline
