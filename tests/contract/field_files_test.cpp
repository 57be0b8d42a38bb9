// SPDX-License-Identifier: GPL-3.0-or-later
// Files from the field that were refused or taken wrongly, from the folders that RIMLINE_DATA names.
#include <doctest/doctest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tool.h"

using namespace rimline::test;

namespace {

namespace fs = std::filesystem;

// The file of that name below any folder of RIMLINE_DATA; empty, and said aloud, where there is none.
std::string file_of(const std::string& name) {
  const char* folders = std::getenv("RIMLINE_DATA");
  std::istringstream list(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!fs::is_directory(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().filename() == name) return entry.path().string();
    }
  }
  MESSAGE("skipped: RIMLINE_DATA has no file ", name);
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string info(const std::string& path) { return rimline::test::rimline({"info", path}).out; }

}  // namespace

TEST_CASE("a table of a measuring machine has its numbers of points as ids") {
  const std::string path = file_of("cmm_id_x_y_z.txt");
  if (path.empty()) return;
  const std::string told = info(path);
  CHECK(contains(told, "columns 2, 3 and 4"));
  CHECK(contains(told, "were taken for id x y z, as the first column counts 1, 2, 3 ..."));
}

TEST_CASE("PDAL's PCD with X Y Z is read") {
  const std::string path = file_of("pdal_autzen-utm.pcd");
  if (path.empty()) return;
  const std::string told = info(path);
  CHECK(contains(told, "1,065"));
  CHECK(contains(told, "493994.87 to 494993.68"));
  CHECK(contains(told, "ushort red, ushort green, ushort blue"));
}

TEST_CASE("a PTX that is cut short is named as that") {
  const std::string path = file_of("pdal_1.2-with-color_head.ptx");
  if (path.empty()) return;
  const Finished done = rimline::test::rimline({"info", path});
  CHECK(done.status == 2);
  CHECK(contains(done.err, "line 1: is a PTX file"));
}

TEST_CASE("the # line of an ILVIS2 file names the columns") {
  const std::string path = file_of("ilvis2.txt");
  if (path.empty()) return;
  const std::string told = info(path);
  CHECK(contains(told, "LONGITUDE_CENTROID, LATITUDE_CENTROID, ELEVATION_CENTROID (columns 4, 5 and 6)"));
  CHECK(contains(told, "which are angles"));
}

TEST_CASE("a mesh in UTM keeps all its corners in STL, less an offset that the report names") {
  const std::string path = file_of("utm_10cm.ply");
  if (path.empty()) return;
  const Folder folder;
  const Finished done = rimline::test::rimline(
      {"reconstruct", path, "-o", folder / "m.stl", "--report", folder / "r.json", "--quiet"});
  REQUIRE(done.status == 0);
  bool named = false;
  const auto report = nlohmann::json::parse(read_file(folder / "r.json"));
  for (const auto& warning : report.at("warnings"))
    named = named || contains(warning.get<std::string>(), "were taken off x, y and z");
  CHECK(named);
  CHECK(report.at("mesh").at("offset") != nlohmann::json({0.0, 0.0, 0.0}));
  const std::string stl = read_file(folder / "m.stl");
  CHECK(contains(stl.substr(0, 80), "add "));
  std::set<std::string> corners;
  for (std::size_t at = 84; at + 50 <= stl.size(); at += 50) {
    for (std::size_t c = 0; c < 3; ++c) corners.insert(stl.substr(at + 12 + 12 * c, 12));
  }
  CHECK(corners.size() == 3600);
}
