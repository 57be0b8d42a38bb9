// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <nlohmann/json.hpp>

#include "io/files.h"

namespace rimline {
namespace {

const std::vector<Loop> two_loops = {{{0, 1, 2, 3}, LoopKind::Outer, 4, 0.1},
                                     {{6, 5, 4}, LoopKind::Hole, 3.5, 2}};
const std::vector<Point> points = {{0, 0, 0},       {1, 0, 0},      {1, 1, 0.5},   {0, 1, 0},
                                   {0.25, 0.25, 0}, {0.5, 0.25, 0}, {0.5, 0.5, 0}, {9, 9, 9}};

std::string written(const std::string& name) {
  const TemporaryDirectory directory;
  write_loops(directory.file(name), two_loops, points, {});
  CHECK(directory.names() == std::vector<std::string>{name});
  return content_of(directory.file(name));
}

TEST_CASE("LOOPS.json has schema 1 and the keys of the contract") {
  const auto json = nlohmann::json::parse(loops_to_json(two_loops, 8));
  CHECK(json["schema"] == 1);
  CHECK(json["points"] == 8);
  REQUIRE(json["loops"].size() == 2);
  const auto& hole = json["loops"][1];
  CHECK(hole["id"] == 1);
  CHECK(hole["kind"] == "hole");
  CHECK(hole["closed"] == true);
  CHECK(hole["points"] == std::vector<int>{6, 5, 4});
  CHECK(hole["length"] == 3.5);
  CHECK(hole["fitness"] == 2);
  CHECK(nlohmann::json::parse(loops_to_json({}, 0))["loops"].empty());
  const Loop unknown{{0, 1, 2}, LoopKind::Outer, std::numeric_limits<double>::infinity(), std::nan("")};
  CHECK(nlohmann::json::parse(loops_to_json({unknown}, 3))["loops"][0]["length"].is_null());
}

TEST_CASE("loops that are written are read back") {
  const TemporaryDirectory directory;
  write_loops(directory.file("l.json"), two_loops, points, {});
  const auto back = read_loops(directory.file("l.json"), 8);
  REQUIRE(back.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(back[i].points == two_loops[i].points);
    CHECK(back[i].kind == two_loops[i].kind);
    CHECK(back[i].length == two_loops[i].length);
    CHECK(back[i].fitness == two_loops[i].fitness);
  }
}

TEST_CASE("loops made by hand need nothing but points, and may repeat the first id at the end") {
  const TemporaryDirectory directory;
  const auto loops = read_loops(
      directory.file("l.json", R"({"loops": [{"points": [3, 0, 2, 3]}, {"points": [4, 5, 6]}]})"), 7);
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].points == std::vector<Index>{3, 0, 2});
  CHECK(loops[0].kind == LoopKind::Outer);
  CHECK(read_loops(directory.file("n.json", R"({"loops": [{"points": [1, 2, 3], "kind": null}]})"), 7)[0].kind ==
        LoopKind::Outer);
}

TEST_CASE("loops honour the memory limit, also where a small file would become a large tree") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("l.json", R"({"loops": [{"points": [0, 1, 2]}], "x": [)" +
                                                        std::string(20000, ' ') + "]}");
  Run run;
  run.memory_limit = 1'000'000;
  CHECK(read_loops(path, 3, run).size() == 1);
  for (const std::size_t limit : {100'000, 10'000}) {
    run.memory_limit = limit;
    try {
      read_loops(path, 3, run);
      FAIL("was read");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::OutOfMemory);
      CHECK(contains(error.what(), "l.json"));
    }
  }
}

TEST_CASE("loops that can not be right are refused by number") {
  const TemporaryDirectory directory;
  const auto complaint_of = [&](const std::string& text) -> std::string {
    try {
      read_loops(directory.file("l.json", text), 7);
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::CannotRead);
      CHECK(contains(error.what(), "l.json"));
      return error.what();
    }
    return {};
  };
  CHECK(contains(complaint_of(R"({"loops": [{"points": [0, 1, 7]}]})"),
                 "loop 0 has the id '7'; ids are integers from 0 to 6"));
  CHECK(contains(complaint_of(R"({"loops": [{"points": [0, 1, -1]}]})"), "'-1'"));
  CHECK(contains(complaint_of(R"({"loops": [{"points": [0, 1, 2.5]}]})"), "'2.5'"));
  CHECK(contains(complaint_of(R"({"loops": [{"points": [0, 1, 2]}, {"points": [0, 1, 0]}]})"),
                 "loop 1 has fewer than three"));
  CHECK(contains(complaint_of(R"({"loops": [{"points": [0, 1, 2, 1]}]})"), "loop 0 has the id 1 twice"));
  CHECK(contains(complaint_of(R"({"loops": [{"points": [0, 1, 2], "kind": "rim"}]})"),
                 "known are outer and hole"));
  CHECK(contains(complaint_of(R"({"loops": [{"points": [0, 1, 2], "closed": false}]})"), "not closed"));
  CHECK(contains(complaint_of(R"({"loops": [{}]})"), "loop 0 has no list 'points'"));
  CHECK(contains(complaint_of(R"({"loops": [], "points": 8})"), "made for 8 points, but the cloud has 7"));
  CHECK(contains(complaint_of(R"({"schema": 2, "loops": []})"), "reads schema 1"));
  CHECK(contains(complaint_of("[]"), "has no list 'loops'"));
  CHECK(contains(complaint_of("{\n\"loops\": [\n"), "line 2: is not valid JSON"));
  CHECK(contains(complaint_of("{\n\"loops\": [\n"), "correct it there, or write the loops again"));
  CHECK_FALSE(contains(complaint_of("{\"loops\": [{\"points\": [1e999]}]}"), "json.exception"));
  CHECK(contains(complaint_of(""), "is empty"));
  CHECK(contains(complaint_of(R"({"loops": [{"points": [)" + std::string(200000, '[') +
                              std::string(200000, ']') + "]}]}"),
                 "an array"));
}

TEST_CASE("exports of loops close each loop and keep all digits") {
  const auto geojson = nlohmann::json::parse(written("l.geojson"));
  CHECK(geojson["type"] == "FeatureCollection");
  REQUIRE(geojson["features"].size() == 2);
  const auto& ring = geojson["features"][0]["geometry"]["coordinates"];
  REQUIRE(ring.size() == 5);
  CHECK(ring[0] == ring[4]);
  CHECK(ring[2] == std::vector<double>{1, 1, 0.5});
  CHECK(geojson["features"][1]["properties"]["kind"] == "hole");
  CHECK(written("l.wkt") ==
        "LINESTRING Z (0 0 0, 1 0 0, 1 1 0.5, 0 1 0, 0 0 0)\nLINESTRING Z (0.5 0.5 0, 0.5 0.25 0, 0.25 0.25 "
        "0, 0.5 0.5 0)\n");
  CHECK(written("l.csv") ==
        "loop,kind,order,point,x,y,z\n0,outer,0,0,0,0,0\n0,outer,1,1,1,0,0\n0,outer,2,2,1,1,0.5\n0,outer,3,3,"
        "0,1,0\n"
        "1,hole,0,6,0.5,0.5,0\n1,hole,1,5,0.5,0.25,0\n1,hole,2,4,0.25,0.25,0\n");
  CHECK(contains(written("l.obj"), "o outer_0\nv 0 0 0\n"));
  CHECK(contains(written("l.obj"), "\nl 1 2 3 4 1\n"));
  CHECK(contains(written("l.obj"), "\nl 5 6 7 5\n"));
  const std::string ply = written("l.ply");
  const Cloud cloud = read_bytes("l.ply", ply);
  CHECK(values(cloud, "point") == std::vector<double>{0, 1, 2, 3, 6, 5, 4});
  CHECK(contains(ply, "element edge 7\n"));
  CHECK(contains(ply, "\n3 0\n4 5\n5 6\n6 4\n"));
  const std::string dxf = written("l.dxf");
  CHECK(contains(dxf, "0\nVERTEX\n8\nOUTER\n10\n1\n20\n1\n30\n0.5\n70\n32\n"));
  CHECK(dxf.substr(dxf.size() - 6) == "0\nEOF\n");
  CHECK(nlohmann::json::parse(written("l.json"))["points"] == 8);
}

TEST_CASE("an unknown ending of loops is a bad option that lists the known ones") {
  CHECK_NOTHROW(check_loops_path("-"));
  CHECK_NOTHROW(check_loops_path("a/b.GeoJSON"));
  try {
    check_loops_path("a.shp");
    FAIL("was taken");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::BadOption);
    CHECK(contains(error.what(), ".geojson"));
  }
}

}  // namespace
}  // namespace rimline
