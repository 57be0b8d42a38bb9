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
    CHECK(broken_rule(mesh.faces, static_cast<int>(mesh.vertices)) == "");
  }
}
