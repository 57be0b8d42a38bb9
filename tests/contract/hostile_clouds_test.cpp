// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds that have broken the tool, from the folders that the environment variable RIMLINE_DATA names.
#include <doctest/doctest.h>

#include <algorithm>

#include "../data.h"
#include "../mesh_rules.h"
#include "ply.h"
#include "tool.h"

using namespace rimline::test;
using rimline::data_files;

TEST_CASE("clouds of lines, plates and blobs end with a mesh that is one, or are refused: nothing crashes") {
  for (const std::string& file : data_files("crash_")) {
    const Folder folder;
    CAPTURE(file);
    const Finished done = rimline::test::rimline({"reconstruct", file, "-o", folder / "mesh.ply", "--quiet"});
    CAPTURE(done.err);
    CHECK((done.status == 0 || done.status == 3));
    if (done.status != 0) continue;
    const Ply mesh = parse_ply(read_file(folder / "mesh.ply"));
    CHECK_FALSE(mesh.faces.empty());
    const int vertices = static_cast<int>(mesh.vertices);
    CHECK(broken_rule(mesh.faces, vertices, false) == "");
    CHECK(broken_rule(two_sided(mesh.faces), vertices) == "");
  }
}

TEST_CASE("the oracle tells a strip that is turned once from one that is not") {
  const std::vector<Corners> ring{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 0}, {5, 1, 0}};
  CHECK(two_sided(ring) == ring);
  std::vector<Corners> moebius = ring;
  moebius[4] = {4, 5, 1};
  moebius[5] = {5, 0, 1};
  CHECK(two_sided(moebius).empty());
  std::vector<Corners> badly = ring;
  std::swap(badly[2][0], badly[2][1]);
  CHECK(two_sided(badly) == badly);
  CHECK(broken_rule(two_sided(badly), 6) == "two triangles run along an edge alike");
}
