// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked of a mesh beyond the mesh.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ply.h"
#include "tool.h"

using namespace rimline::test;
using nlohmann::json;

namespace {

// An outer loop and holes.
std::string sheet_with_holes(const Folder& folder) {
  std::string path = folder / "sheet.ply";
  REQUIRE(rimline::test::rimline({"sample", "square-with-holes", "-n", "3000", "-o", path, "-q"}).status ==
          0);
  return path;
}

struct Result {
  json report, loops;
  std::string mesh;
};

Result reconstruct(const Folder& folder, const std::string& input, std::vector<std::string> more) {
  std::vector<std::string> arguments = {
      "reconstruct",     input, "-o", folder / "m.ply", "--report", folder / "r.json", "--loops",
      folder / "l.json", "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Finished finished = rimline::test::rimline(arguments);
  CAPTURE(finished.err);
  REQUIRE(finished.status == 0);
  return {json::parse(read_file(folder / "r.json")), json::parse(read_file(folder / "l.json")),
          read_file(folder / "m.ply")};
}

}  // namespace

TEST_CASE("--holes keep, fill and fill:MAX say the same in mesh, loops and report") {
  const Folder folder;
  const std::string input = sheet_with_holes(folder);
  const Result kept = reconstruct(folder, input, {});
  const std::size_t found = kept.loops["loops"].size();
  REQUIRE(found > 1);
  const auto input_points = kept.report["points"]["input"].get<std::size_t>();
  CHECK(kept.report["mesh"]["boundary_loops"] == found);
  CHECK(kept.report["holes"]["kept"] == found - 1);
  CHECK(kept.mesh.find("property uchar filled") == std::string::npos);

  for (const bool points : {false, true}) {
    std::vector<std::string> more = {"--holes", "fill"};
    if (points) more.push_back("--fill-points");
    const Result filled = reconstruct(folder, input, more);
    CHECK(filled.loops["loops"].size() == 1);
    CHECK(filled.loops["points"] == input_points);
    CHECK(filled.report["mesh"]["boundary_loops"] == 1);
    CHECK(filled.report["mesh"]["euler_number"] == 1);
    CHECK(filled.report["mesh"]["nonmanifold_edges"] == 0);
    CHECK(filled.report["mesh"]["uv_flips"] == 0);
    CHECK(filled.report["holes"]["filled"] == found - 1);
    CHECK((filled.report["holes"]["added_points"] > 0) == points);
    CHECK(filled.report["points"]["unmeshed"] == 0);
    const std::size_t vertices = input_points + filled.report["holes"]["added_points"].get<std::size_t>();
    CHECK(filled.mesh.find("element vertex " + std::to_string(vertices)) != std::string::npos);
    CHECK(filled.mesh.find("property uchar filled") != std::string::npos);
  }

  std::size_t least = 3000;
  for (const json& loop : kept.loops["loops"]) {
    if (loop["kind"] == "hole") least = std::min(least, loop["points"].size());
  }
  const Result some = reconstruct(folder, input, {"--holes", "fill:" + std::to_string(least)});
  CHECK(some.report["holes"]["filled"] >= 1);
  CHECK(some.report["holes"]["fills"][0]["points"] <= least);
  const Result none = reconstruct(folder, input, {"--holes", "fill:0.0001u"});
  CHECK(none.report["holes"]["filled"] == 0);
}

TEST_CASE("fills reach every format, with their vertices") {
  const Folder folder;
  const std::string input = sheet_with_holes(folder);
  for (const char* ending : {"obj", "off", "stl", "glb"}) {
    CAPTURE(ending);
    const std::string output = folder / (std::string("mesh.") + ending);
    CHECK(
        rimline::test::rimline({"reconstruct", input, "-o", output, "--holes", "fill", "--fill-points", "-q"})
            .status == 0);
    CHECK(read_file(output).size() > 10'000);
  }
}

TEST_CASE("a bad --holes or --corners is refused with a sentence that teaches it") {
  const Folder folder;
  const std::string input = sheet_with_holes(folder);
  const auto refused = [&](std::vector<std::string> more, const std::string& lesson) {
    std::vector<std::string> arguments = {"reconstruct", input, "-o", folder / "m.ply"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished finished = rimline::test::rimline(arguments);
    CAPTURE(finished.err);
    CHECK(finished.status == 1);
    CHECK(finished.err.find(lesson) != std::string::npos);
  };
  refused({"--holes", "fill:2.5"}, "fill:2.5u");
  refused({"--holes", "close"}, "keep, fill");
  refused({"--preset", "paper", "--holes", "fill"}, "--holes");
  refused({"--domain", "square", "--corners", "1,2,3"}, "A,B,C,D");
  refused({"--domain", "square", "--corners", "1,2,3,999999"}, "corner");
  refused({"--corners", "1,2,3,4"}, "square");
}

TEST_CASE("--distortion adds properties to points and faces, the report has their summary always") {
  const Folder folder;
  const std::string input = sheet_with_holes(folder);
  const Result plain = reconstruct(folder, input, {"--domain", "free"});
  CHECK(plain.mesh.find("angle_distortion") == std::string::npos);
  CHECK(plain.report["distortion"]["angle_mean"] > 0);
  CHECK(plain.report["distortion"]["stretch_l2"] >= 1);
  CHECK(plain.report["components"][0]["distortion"]["angle_mean"] > 0);
  const Result asked = reconstruct(folder, input, {"--domain", "free", "--distortion"});
  const std::string header = asked.mesh.substr(0, asked.mesh.find("end_header"));
  const std::size_t face = header.find("element face");
  for (const char* property : {"angle_distortion", "area_distortion", "stretch_l2", "stretch_linf"}) {
    CAPTURE(property);
    const std::size_t first = header.find(std::string("property float ") + property);
    CHECK(first < face);
    CHECK(header.find(std::string("property float ") + property, face) != std::string::npos);
  }
}

TEST_CASE("a mesh measured against itself is at distance 0 with all edges agreeing") {
  const Folder folder;
  const std::string input = sheet_with_holes(folder);
  reconstruct(folder, input, {});
  write_file(folder / "reference.ply", read_file(folder / "m.ply"));
  const Result same = reconstruct(folder, input, {"--reference", folder / "reference.ply"});
  CHECK(same.report["reference"]["hausdorff"] < 1e-9);
  CHECK(same.report["reference"]["edges_agree"] == 1);
  CHECK(same.report["mesh"]["self_intersections"] == 0);
  CHECK(same.report["components"][0]["mesh_to_reference"]["mean"] < 1e-9);
  CHECK(rimline::test::rimline({"reconstruct", input, "-o", folder / "m.ply", "--reference", input}).status ==
        2);
}

TEST_CASE("--uv-picture draws PNG and SVG") {
  const Folder folder;
  const std::string input = sheet_with_holes(folder);
  reconstruct(folder, input, {"--uv-picture", folder / "uv.png"});
  CHECK(read_file(folder / "uv.png").substr(1, 3) == "PNG");
  reconstruct(folder, input, {"--uv-picture", folder / "uv.svg"});
  CHECK(read_file(folder / "uv.svg").find("<svg") != std::string::npos);
}

TEST_CASE("--charts and --uv-scale: a ball in the unit square, by two charts or by five") {
  const Folder folder;
  const std::string input = folder / "ball.ply";
  REQUIRE(rimline::test::rimline({"sample", "closed-sphere", "-n", "1500", "-o", input, "-q"}).status == 0);
  for (const auto& [charts, count] : {std::pair<std::string, int>{"auto", 2}, {"5", 5}}) {
    CAPTURE(charts);
    const Result result =
        reconstruct(folder, input, {"--domain", "free", "--charts", charts, "--uv-scale", "unit"});
    CHECK(result.report["map"]["charts"] == count);
    CHECK(result.report["map"]["seam_length"] > 5);
    CHECK(result.report["options"]["charts"] == (charts == "auto" ? json("auto") : json(5)));
    CHECK(result.report["distortion"]["stretch_l2"] < 2);
    CHECK(result.report["mesh"]["uv_flips"] == 0);
    const Ply mesh = parse_ply(result.mesh);
    REQUIRE(mesh.texcoord.size() == mesh.faces.size());
    for (const auto& corners : mesh.texcoord) {
      for (const double value : corners) CHECK((value >= 0 && value <= 1));
    }
  }
  const Finished refused =
      rimline::test::rimline({"reconstruct", input, "-o", folder / "m.ply", "--charts", "none"});
  CHECK(refused.status == 1);
}

TEST_CASE("--texture-size bakes colours for OBJ and glTF, and says what it wants") {
  const Folder folder;
  std::string rows;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) rows += fmt::format("{} {} 0 {} 0 {}\n", x, y, 12 * x, 12 * y);
  }
  const std::string input = folder / "sheet.ply";
  write_file(
      input,
      "ply\nformat ascii 1.0\nelement vertex 400\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n" +
          rows);
  const auto run = [&](const std::string& mesh, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"reconstruct", input, "-o", folder / mesh, "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return rimline::test::rimline(arguments);
  };
  REQUIRE(run("m.obj", {"--texture-size", "64", "--domain", "free"}).status == 0);
  CHECK(read_file(folder / "m.png").starts_with("\x89PNG"));
  CHECK(read_file(folder / "m.mtl").find("map_Kd m.png") != std::string::npos);
  REQUIRE(run("m.glb", {"--texture-size", "64", "--texture-property", "x", "--domain", "free"}).status == 1);
  REQUIRE(run("m.glb", {"--texture-size", "64", "--texture-property", "red"}).status == 0);
  CHECK(read_file(folder / "m.glb").find("\x89PNG") != std::string::npos);
  CHECK(run("m.ply", {"--texture-size", "64"}).status == 1);
  CHECK(run("m.obj", {"--texture-size", "0"}).status == 1);
  CHECK(run("m.obj", {"--texture-size", "64", "--uv-scale", "real"}).status == 1);
  CHECK(run("m.obj", {"--texture-property", "red"}).status == 1);
}
