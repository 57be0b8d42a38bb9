// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster.h"

#include <doctest/doctest.h>

using namespace rimline::cli;

namespace {
std::uint32_t at(const Raster& raster, int x, int y) { return raster.pixels()[y * raster.width() + x]; }
constexpr std::uint32_t red = 0xffff0000, blue = 0xff0000ff;
}  // namespace

TEST_CASE("what is nearer to the eye hides what is farther, in either order of drawing") {
  for (const bool near_first : {true, false}) {
    Raster raster(10, 10);
    if (near_first) raster.disc({5, 5, 2}, 3, {1, 0, 0});
    raster.disc({5, 5, 1}, 3, {0, 0, 1});
    if (!near_first) raster.disc({5, 5, 2}, 3, {1, 0, 0});
    CHECK(at(raster, 5, 5) == red);
    CHECK_FALSE(raster.sees({5, 5, 1}, 0.5));
    CHECK(raster.sees({5, 5, 2}, 0));
  }
}

TEST_CASE("two triangles that cross show the nearer one on each side") {
  Raster raster(20, 20);
  raster.triangle({-50, -50, -10}, {50, -50, 10}, {0, 100, 0}, {1, 0, 0});  // rises to the right
  raster.triangle({-50, -50, 14}, {50, -50, -6}, {0, 100, 4}, {0, 0, 1});  // falls to the right
  CHECK(at(raster, 0, 10) == blue);
  CHECK(at(raster, 19, 10) == red);
}

TEST_CASE("a screen hides what lies behind it and shows nothing itself") {
  Raster raster(10, 10);
  raster.screen({5, 5, 1}, 3);
  CHECK(at(raster, 5, 5) == 0);
  raster.disc({5, 5, 0}, 3, {1, 0, 0});
  CHECK(at(raster, 5, 5) == 0);
  raster.disc({5, 5, 2}, 1, {1, 0, 0});
  CHECK(at(raster, 5, 5) == red);
}

TEST_CASE("what lies outside of the image is left out") {
  Raster raster(4, 4);
  raster.disc({-100, 2, 0}, 5, {1, 0, 0});
  raster.triangle({100, 100, 0}, {120, 100, 0}, {100, 120, 0}, {1, 0, 0});
  raster.triangle({1, 1, 0}, {2, 2, 0}, {3, 3, 0}, {1, 0, 0});  // no area
  for (const auto pixel : raster.pixels()) CHECK(pixel == 0);
}
