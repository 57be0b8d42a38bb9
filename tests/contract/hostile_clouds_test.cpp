// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds that have broken the tool, from the folders that the environment variable RIMLINE_DATA names.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "ply.h"
#include "tool.h"

using namespace rimline::test;

namespace {

// The files of RIMLINE_DATA, below any of its folders, whose names start so; said aloud where there are none.
std::vector<std::string> data_files(const std::string& start) {
  std::vector<std::string> files;
  const char* folders = std::getenv("RIMLINE_DATA");
  std::istringstream names(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(names, folder, ':');) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().filename().string().starts_with(start)) files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) MESSAGE("skipped: RIMLINE_DATA has no file ", start, "*");
  return files;
}

}  // namespace

TEST_CASE("clouds of lines, plates and blobs are meshed or refused: nothing crashes") {
  for (const std::string& file : data_files("crash_")) {
    const Folder folder;
    CAPTURE(file);
    const Finished done = rimline::test::rimline({"reconstruct", file, "-o", folder / "mesh.ply", "--quiet"});
    CAPTURE(done.err);
    CHECK((done.status == 0 || done.status == 3));
    if (done.status != 0) continue;
    const Ply mesh = parse_ply(read_file(folder / "mesh.ply"));
    CHECK_FALSE(mesh.faces.empty());
    for (const auto& face : mesh.faces) {
      for (const int v : face) CHECK((v >= 0 && v < static_cast<int>(mesh.vertices)));
    }
  }
}
