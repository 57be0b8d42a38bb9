// SPDX-License-Identifier: GPL-3.0-or-later
// --use-loops: a boundary made by hand, with what hands get wrong.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tool.h"

using namespace rimline::test;
using nlohmann::json;
using Names = std::vector<std::string>;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

constexpr int side = 15;
int id(int x, int y) { return y * side + x; }

// A slightly bent square grid, all of it; the loops say where its hole is.
std::string grid() {
  std::string text;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) text += fmt::format("{} {} {}\n", x, y, 0.01 * x * y);
  }
  return text;
}

// Around the square from (low, low) to (high, high).
json ring(int low, int high) {
  json points = json::array();
  for (int i = low; i < high; ++i) points.push_back(id(i, low));
  for (int i = low; i < high; ++i) points.push_back(id(high, i));
  for (int i = high; i > low; --i) points.push_back(id(i, high));
  for (int i = high; i > low; --i) points.push_back(id(low, i));
  return points;
}

Finished reconstruct_with(const Folder& folder, const json& loops, const Names& more = {}) {
  write_file(folder / "grid.xyz", grid());
  write_file(folder / "loops.json", json{{"loops", loops}}.dump());
  Names arguments = {"reconstruct", folder / "grid.xyz",   "-o",      folder / "mesh.ply",
                     "--use-loops", folder / "loops.json", "--loops", folder / "out.json",
                     "--report",    folder / "report.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run({.arguments = arguments});
}

}  // namespace

TEST_CASE("given loops that share points are refused with the ids, and nothing is written") {
  for (const std::string preset : {"default", "paper"}) {
    const Folder folder;
    const json touching = {id(0, 0), id(1, 1), id(2, 0)};
    const Finished refused = reconstruct_with(
        folder, {{{"points", ring(0, side - 1)}}, {{"points", touching}}}, {"--preset", preset});
    CAPTURE(refused.err);
    CHECK(refused.status == 1);
    CHECK(contains(refused.err, "(2 points: 0, 2)"));
    CHECK(folder.names() == Names{"grid.xyz", "loops.json"});
  }
}

TEST_CASE("where a file of loops holds none, they are looked for, and that is said") {
  const Folder folder;
  const Finished done = reconstruct_with(folder, json::array());
  CAPTURE(done.err);
  CHECK(done.status == 0);
  CHECK(contains(read_file(folder / "report.json"), "loops.json: has no loops, so they are looked for"));
  CHECK(json::parse(read_file(folder / "out.json"))["loops"].size() == 1);
}

TEST_CASE("a given loop that passes a point twice is refused with the id") {
  const Folder folder;
  json loop = ring(0, side - 1);
  loop.push_back(id(3, 3));
  loop.push_back(id(7, 0));
  const Finished refused = reconstruct_with(folder, {{{"points", loop}}});
  CAPTURE(refused.err);
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, "has the id 7 twice"));
}

TEST_CASE("the kind of a given loop is found where it is not given, so that holes can be filled") {
  const json outer = {{"points", ring(0, side - 1)}}, hole = {{"points", ring(5, 9)}};
  const auto as = [](json loop, const json& kind) { return loop["kind"] = kind, loop; };
  const std::vector<std::pair<json, Names>> cases = {
      {{outer, hole}, {"outer", "hole"}},
      {{hole, outer}, {"hole", "outer"}},
      {{as(hole, nullptr), as(outer, "outer")}, {"hole", "outer"}},
      {{as(outer, "hole"), hole}, {"hole", "outer"}},  // what is given stands
  };
  for (const auto& [loops, kinds] : cases) {
    const Folder folder;
    const Finished open = reconstruct_with(folder, loops, {"--allow-partial"});
    CAPTURE(loops.dump());
    CAPTURE(open.err);
    REQUIRE(open.status == 0);
    const json out = json::parse(read_file(folder / "out.json"));
    REQUIRE(out["loops"].size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(out["loops"][i]["points"].size() == loops[i]["points"].size());
      CHECK(out["loops"][i]["kind"] == kinds[i]);
    }
  }
  const Folder folder;
  REQUIRE(reconstruct_with(folder, {hole, outer}, {"--allow-partial", "--holes", "fill"}).status == 0);
  const json report = json::parse(read_file(folder / "report.json"));
  CHECK(report["holes"]["filled"] == 1);
  CHECK(report["mesh"]["boundary_loops"] == 1);
}

TEST_CASE("each part of a surface has an outer loop of its own among loops whose kind is not given") {
  const Folder folder;
  std::string far;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) far += fmt::format("{} {} 0\n", x + 100, 0.3 * y);
  }
  json second = ring(0, side - 1);
  for (json& point : second) point = point.get<int>() + side * side;
  write_file(folder / "two.xyz", grid() + far);
  write_file(folder / "loops.json",
             json{{"loops", {{{"points", second}}, {{"points", ring(0, side - 1)}}}}}.dump());
  const Finished done =
      rimline::test::rimline({"reconstruct", folder / "two.xyz", "-o", folder / "mesh.ply", "--use-loops",
                              folder / "loops.json", "--loops", folder / "out.json"});
  CAPTURE(done.err);
  REQUIRE(done.status == 0);
  const json written = json::parse(read_file(folder / "out.json"));
  for (const json& loop : written["loops"]) CHECK(loop["kind"] == "outer");
}

TEST_CASE("--use-loops honours --memory-limit") {
  const Folder folder;
  const Names limit = {"--memory-limit", "60M", "--allow-partial"};
  REQUIRE(reconstruct_with(folder, {{{"points", ring(0, side - 1)}}}, limit).status == 0);
  json padded = {{"points", ring(0, side - 1)}};
  padded["note"] = std::string(3'000'000, ' ');
  const Finished refused = reconstruct_with(folder, {padded}, limit);
  CAPTURE(refused.err);
  CHECK(refused.status == 4);
  CHECK(contains(refused.err, "loops.json"));
  CHECK(contains(refused.err, "60000000"));
}
