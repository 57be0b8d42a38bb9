// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/manifold.h"

#include <doctest/doctest.h>

#include <random>

#include "mesh_rules.h"

namespace rimline {
namespace {

// side * side points in rows.
std::vector<Triangle> grid(Index side) {
  std::vector<Triangle> triangles;
  for (Index y = 0; y + 1 < side; ++y) {
    for (Index x = 0; x + 1 < side; ++x) {
      const Index a = y * side + x;
      triangles.push_back({a, a + 1, a + side + 1});
      triangles.push_back({a, a + side + 1, a + side});
    }
  }
  return triangles;
}

Loop border(Index side) {
  Loop loop;
  for (Index i = 0; i + 1 < side; ++i) loop.points.push_back(i);
  for (Index i = 0; i + 1 < side; ++i) loop.points.push_back(side - 1 + i * side);
  for (Index i = side - 1; i > 0; --i) loop.points.push_back((side - 1) * side + i);
  for (Index i = side - 1; i > 0; --i) loop.points.push_back(i * side);
  return loop;
}

std::string fault(const std::vector<Triangle>& triangles, const std::vector<Loop>& loops,
                  bool orientable = true) {
  return fault_of(triangles, 100, loops, orientable, {});
}

}  // namespace

TEST_CASE("a grid that ends at its border has no fault") { CHECK(fault(grid(6), {border(6)}) == ""); }

TEST_CASE("each fault of a mesh is named") {
  const std::vector<Triangle> sound = grid(6);
  const auto with = [&](std::vector<Triangle> more) {
    std::vector<Triangle> all = sound;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  CHECK(fault({}, {}) == "there is no triangle");
  CHECK(fault(with({{0, 0, 1}}), {border(6)}) == "a corner is repeated or no vertex");
  CHECK(fault(with({{0, 1, 100}}), {border(6)}) == "a corner is repeated or no vertex");
  CHECK(fault(with({{7, 8, 50}}), {border(6)}) == "an edge has more than two triangles");
  CHECK(fault({{0, 1, 2}, {0, 1, 2}}, {}) == "a triangle is there twice");
  CHECK(fault({{0, 1, 2}, {0, 2, 1}}, {}) == "a triangle is there twice");
  CHECK(fault(with({{0, 50, 51}}), {border(6)}) == "the triangles of a vertex form more than one fan");
  std::vector<Triangle> turned = sound;
  std::swap(turned[20][0], turned[20][1]);
  CHECK(fault(turned, {border(6)}) == "neighbours do not face the same way");
  CHECK(fault(turned, {border(6)}, false) == "");
  CHECK(fault(sound, {}) == "the boundary is not the loops");
  CHECK(fault(sound, {border(5)}) == "the boundary is not the loops");
  Loop inner;
  inner.points = {7, 8, 14};
  CHECK(fault(sound, {border(6), inner}) == "the boundary is not the loops");
}

TEST_CASE("the check finds a fault exactly where the rules say so edge by edge") {
  std::mt19937 random(7);
  std::size_t broken = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<Triangle> triangles = grid(5);
    for (int change = trial % 3; change > 0; --change) {
      Triangle& t = triangles[random() % triangles.size()];
      if (random() % 2 == 0) {
        t[random() % 3] = static_cast<Index>(random() % 25);
      } else {
        t = triangles.back();
        triangles.pop_back();
      }
    }
    Loop rim;  // any closed walk serves to name the edges: only the other rules are compared
    const bool sound = test::broken_rule(triangles, 25) == "";
    const std::string found = fault(triangles, {rim});
    CHECK(sound == (found == "" || found == "the boundary is not the loops"));
    broken += !sound;
  }
  CHECK(broken > 50);
}

}  // namespace rimline
