// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/left_out.h"

#include <doctest/doctest.h>

namespace rimline::pipeline {
namespace {

LeftOut group(std::vector<Index> ids) {
  LeftOut part;
  part.ids = std::move(ids);
  return part;
}

TEST_CASE("a single point in no triangle counts under strict, and not without it") {
  MappedMesh mesh;
  mesh.triangles = {{0, 1, 2}};
  CHECK(!why_no_mesh(mesh, false));
  CHECK(!why_no_mesh(mesh, true));
  mesh.left_out = {group({7}), group({4, 5})};
  CHECK(!why_no_mesh(mesh, false));
  const auto reason = why_no_mesh(mesh, true);
  REQUIRE(reason);
  CHECK(exit_status(reason->code()) == 3);
  CHECK(reason->ids() == std::vector<Index>{4, 5});
}

TEST_CASE("no triangle is a reason at any time") {
  CHECK(why_no_mesh(MappedMesh(), false));
  CHECK(why_no_mesh(MappedMesh(), true));
}

}  // namespace
}  // namespace rimline::pipeline
