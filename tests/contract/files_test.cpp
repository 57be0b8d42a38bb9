// SPDX-License-Identifier: GPL-3.0-or-later
// What the files hold.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "ply.h"
#include "tool.h"

using namespace rimline::test;
using nlohmann::json;
using Names = std::vector<std::string>;

namespace {

// A small cloud with everything a file may carry, made here: double coordinates far from the origin, colours
// and an intensity per point, and a `boundary` that is wrong on purpose.
struct Row {
  double x, y, z;
  std::uint8_t red, green, blue;
  float intensity;
  std::uint8_t boundary;
};

// A gently curved square of side * side points, jittered so that no two distances are equal.
std::vector<Row> curved_square(int side) {
  std::vector<Row> rows;
  std::uint32_t state = 12345;
  const auto jitter = [&state] {
    state = state * 1664525U + 1013904223U;
    return 0.1 * (static_cast<double>(state >> 8) / (1 << 24) - 0.5);
  };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const bool rim = i == 0 || j == 0 || i == side - 1 || j == side - 1;
      const double x = i + (rim ? 0 : jitter()), y = j + (rim ? 0 : jitter());
      const auto id = static_cast<int>(rows.size());
      rows.push_back({1e6 + 0.001 * x, 5e6 + 0.001 * y, 1e-6 * (x * x - x * y + 3 * y) + 1e-9 * jitter(),
                      static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(id / 256), 77,
                      0.1F * static_cast<float>(id), static_cast<std::uint8_t>(id % 3 == 0)});
    }
  }
  return rows;
}

template <class T>
void append(std::string& bytes, T value) {
  std::array<char, sizeof value> raw;
  std::memcpy(raw.data(), &value, sizeof value);
  bytes.append(raw.data(), raw.size());
}

std::string ply_of(const std::vector<Row>& rows) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property float intensity\nproperty uchar boundary\nend_header\n",
      rows.size());
  for (const Row& row : rows) {
    append(bytes, row.x), append(bytes, row.y), append(bytes, row.z);
    append(bytes, row.red), append(bytes, row.green), append(bytes, row.blue);
    append(bytes, row.intensity), append(bytes, row.boundary);
  }
  return bytes;
}

json without_run(const std::string& report) {
  json parsed = json::parse(report);
  REQUIRE(parsed.contains("run"));
  parsed.erase("run");
  return parsed;
}

void require_done(const Finished& finished) {
  CAPTURE(finished.err);
  REQUIRE(finished.status == 0);
}

std::string sample(const Folder& folder, const std::string& shape, int n) {
  std::string path = folder / "sample.ply";
  require_done(rimline::test::rimline({"sample", shape, "-n", std::to_string(n), "-o", path, "--quiet"}));
  return path;
}

// Everything the rows hold, by bytes, in the properties of the file.
void check_passed_through(const Ply& ply, const std::vector<Row>& rows) {
  REQUIRE(ply.vertices == rows.size());
  for (const char* property :
       {"double x", "double y", "double z", "uchar red", "uchar green", "uchar blue", "float intensity"}) {
    CAPTURE(property);
    CHECK(ply.has(property));
  }
  const auto x = ply.values<double>("x"), y = ply.values<double>("y"), z = ply.values<double>("z");
  const auto red = ply.values<std::uint8_t>("red"), green = ply.values<std::uint8_t>("green");
  const auto intensity = ply.values<float>("intensity");
  std::size_t same = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    same += x[i] == rows[i].x && y[i] == rows[i].y && z[i] == rows[i].z && red[i] == rows[i].red &&
            green[i] == rows[i].green && intensity[i] == rows[i].intensity;
  }
  CHECK(same == rows.size());
}

using Triple = std::array<double, 3>;

// Triangles as coordinates, each from its least corner on, so that they compare without ids.
std::set<std::array<Triple, 3>> triangles_in_space(const Ply& mesh) {
  const auto x = mesh.values<double>("x"), y = mesh.values<double>("y"), z = mesh.values<double>("z");
  std::set<std::array<Triple, 3>> result;
  for (const auto& face : mesh.faces) {
    std::array<Triple, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = {x[face[i]], y[face[i]], z[face[i]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

}  // namespace

TEST_CASE("boundary gives every point back bit for bit, with flags, loop, p-value and score") {
  const Folder folder;
  const auto rows = curved_square(30);
  write_file(folder / "in.ply", ply_of(rows));
  require_done(rimline::test::rimline(
      {"boundary", folder / "in.ply", "-o", folder / "out.ply", "--loops", folder / "loops.json"}));
  const Ply out = parse_ply(read_file(folder / "out.ply"));
  check_passed_through(out, rows);
  for (const char* property :
       {"uchar boundary", "int loop", "uchar candidate", "double p_value", "double score"}) {
    CAPTURE(property);
    CHECK(out.has(property));
  }
  CHECK(std::count(out.properties.begin(), out.properties.end(), "uchar boundary") == 1);
  const json loops = json::parse(read_file(folder / "loops.json"));
  CHECK(loops.at("schema") == 1);
  REQUIRE(loops.at("loops").size() >= 1);
  std::vector<std::uint8_t> on_loop(rows.size(), 0);
  for (const json& loop : loops["loops"]) {
    for (const char* key : {"id", "kind", "closed", "points", "length", "fitness"}) CHECK(loop.contains(key));
    CHECK(loop["closed"] == true);
    std::set<int> distinct;
    for (const int id : loop["points"]) {
      on_loop.at(static_cast<std::size_t>(id)) = 1;
      distinct.insert(id);
    }
    CHECK(distinct.size() == loop["points"].size());
  }
  CHECK(on_loop == out.values<std::uint8_t>("boundary"));
  const auto loop = out.values<int>("loop");
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK((loop[i] >= 0) == (on_loop[i] == 1));
}

TEST_CASE("reconstruct gives every point back bit for bit as a vertex, with u, v and boundary") {
  const Folder folder;
  const auto rows = curved_square(30);
  write_file(folder / "in.ply", ply_of(rows));
  require_done(rimline::test::rimline({"reconstruct", folder / "in.ply", "-o", folder / "mesh.ply"}));
  const Ply mesh = parse_ply(read_file(folder / "mesh.ply"));
  check_passed_through(mesh, rows);
  for (const char* property : {"double u", "double v", "uchar boundary"}) CHECK(mesh.has(property));
  CHECK(mesh.faces.size() > rows.size());
  const auto u = mesh.values<double>("u"), v = mesh.values<double>("v");
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(std::hypot(u[i], v[i]) <= 1 + 1e-12);
}

TEST_CASE("parameterize gives every point back bit for bit, with u and v") {
  const Folder folder;
  const auto rows = curved_square(30);
  write_file(folder / "in.ply", ply_of(rows));
  require_done(rimline::test::rimline({"parameterize", folder / "in.ply", "-o", folder / "uv.ply"}));
  const Ply out = parse_ply(read_file(folder / "uv.ply"));
  check_passed_through(out, rows);
  CHECK(out.has("double u"));
  CHECK(out.has("double v"));
}

TEST_CASE("float coordinates stay float") {
  const Folder folder;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 900\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  for (const Row& row : curved_square(30)) {
    append(bytes, static_cast<float>(1000 * (row.x - 1e6)));
    append(bytes, static_cast<float>(1000 * (row.y - 5e6)));
    append(bytes, static_cast<float>(row.z));
  }
  write_file(folder / "in.ply", bytes);
  require_done(rimline::test::rimline({"reconstruct", folder / "in.ply", "-o", folder / "mesh.ply"}));
  const Ply in = parse_ply(bytes), mesh = parse_ply(read_file(folder / "mesh.ply"));
  for (const char* name : {"x", "y", "z"}) CHECK(in.raw.at(name) == mesh.raw.at(name));
}

TEST_CASE("a boundary property in the input is never read") {
  const Folder folder;
  auto rows = curved_square(30);
  write_file(folder / "a.ply", ply_of(rows));
  for (Row& row : rows) row.boundary = static_cast<std::uint8_t>(1 - row.boundary);
  write_file(folder / "b.ply", ply_of(rows));
  for (const std::string name : {"a", "b"}) {
    require_done(
        rimline::test::rimline({"reconstruct", folder / (name + ".ply"), "-o", folder / (name + "_mesh.ply"),
                                "--report", folder / (name + ".json")}));
  }
  CHECK(read_file(folder / "a_mesh.ply") == read_file(folder / "b_mesh.ply"));
  CHECK(without_run(read_file(folder / "a.json")) == without_run(read_file(folder / "b.json")));
}

TEST_CASE("duplicates, NaN rows and stray points stay as unused vertices and are counted") {
  const Folder folder;
  auto rows = curved_square(30);
  const std::size_t clean = rows.size();
  rows.push_back(rows[100]);
  rows.push_back(rows[0]);
  rows.push_back({std::nan(""), 5e6, 0, 1, 2, 3, 4, 0});
  rows.push_back({1e6, 5e6, 9e3, 1, 2, 3, 4, 0});  // far from all others
  write_file(folder / "in.ply", ply_of(rows));
  const Finished done = rimline::test::rimline(
      {"reconstruct", folder / "in.ply", "-o", folder / "mesh.ply", "--report", folder / "report.json"});
  require_done(done);
  const Ply mesh = parse_ply(read_file(folder / "mesh.ply"));
  CHECK(mesh.vertices == clean + 4);
  CHECK(std::isnan(mesh.values<double>("x")[clean + 2]));
  int highest = 0;
  for (const auto& face : mesh.faces) highest = std::max({highest, face[0], face[1], face[2]});
  CHECK(highest < static_cast<int>(clean));
  const json points = json::parse(read_file(folder / "report.json")).at("points");
  CHECK(points.at("input") == clean + 4);
  CHECK(points.at("used") == clean);
  CHECK(points.at("duplicates") == 2);
  CHECK(points.at("not_finite") == 1);
  CHECK(points.at("stray") == 1);
  CHECK(done.out.find("2 duplicates") != std::string::npos);
}

TEST_CASE("standard input and output carry the same bytes as files") {
  const Folder folder;
  const std::string input = ply_of(curved_square(30));
  write_file(folder / "in.ply", input);
  require_done(rimline::test::rimline({"reconstruct", folder / "in.ply", "-o", folder / "mesh.ply", "--loops",
                                       folder / "loops.json", "--report", folder / "report.json"}));
  const Finished mesh = run({.arguments = {"reconstruct", "-", "-o", "-"}, .input = input});
  require_done(mesh);
  CHECK(mesh.out == read_file(folder / "mesh.ply"));
  CHECK(mesh.err.find("triangles") != std::string::npos);  // the summary makes way
  const Finished loops = run({.arguments = {"boundary", "-", "--loops", "-"}, .input = input});
  CHECK(json::parse(loops.out).at("loops").size() ==
        json::parse(read_file(folder / "loops.json")).at("loops").size());
  const Finished report =
      run({.arguments = {"reconstruct", "-", "-o", folder / "again.ply", "--report", "-", "--quiet"},
           .input = input});
  CHECK(without_run(report.out) == without_run(read_file(folder / "report.json")));
  CHECK(report.err.empty());
}

TEST_CASE("the number of threads changes no byte of mesh, points, loops and report outside of run") {
  const Folder folder;
  const std::string input = sample(folder, "bumpy-square", 5000);
  for (const std::string preset : {"default", "paper", "paper-log"}) {
    std::vector<std::string> meshes, points, loops;
    std::vector<json> reports;
    for (const std::string threads : {"1", "2"}) {
      require_done(rimline::test::rimline({"reconstruct", input, "-o", folder / "mesh.ply", "--loops",
                                           folder / "loops.json", "--report", folder / "report.json",
                                           "--threads", threads, "--preset", preset}));
      require_done(rimline::test::rimline(
          {"boundary", input, "-o", folder / "points.ply", "--threads", threads, "--preset", preset}));
      meshes.push_back(read_file(folder / "mesh.ply"));
      points.push_back(read_file(folder / "points.ply"));
      loops.push_back(read_file(folder / "loops.json"));
      reports.push_back(without_run(read_file(folder / "report.json")));
    }
    CAPTURE(preset);
    CHECK(meshes[0] == meshes[1]);
    CHECK(points[0] == points[1]);
    CHECK(loops[0] == loops[1]);
    CHECK(reports[0] == reports[1]);
  }
}

TEST_CASE("loops that were written and read again give the same mesh") {
  const Folder folder;
  const std::string input = sample(folder, "hemisphere-cap", 2000);
  require_done(
      rimline::test::rimline({"reconstruct", input, "-o", folder / "a.ply", "--loops", folder / "a.json"}));
  require_done(rimline::test::rimline({"reconstruct", input, "-o", folder / "b.ply", "--loops",
                                       folder / "b.json", "--use-loops", folder / "a.json"}));
  const Ply a = parse_ply(read_file(folder / "a.ply")), b = parse_ply(read_file(folder / "b.ply"));
  CHECK(a.raw.at("boundary") == b.raw.at("boundary"));
  CHECK(triangles_in_space(a) == triangles_in_space(b));
  CHECK(json::parse(read_file(folder / "a.json"))["loops"][0]["points"] ==
        json::parse(read_file(folder / "b.json"))["loops"][0]["points"]);
}

TEST_CASE("a boundary made by hand needs nothing but its points, and is the boundary of the mesh") {
  const Folder folder;
  constexpr int side = 20;
  write_file(folder / "in.ply", ply_of(curved_square(side)));
  json points = json::array();
  for (int i = 0; i < side - 1; ++i) points.push_back(i);
  for (int i = 0; i < side - 1; ++i) points.push_back(i * side + side - 1);
  for (int i = side - 1; i > 0; --i) points.push_back((side - 1) * side + i);
  for (int i = side - 1; i > 0; --i) points.push_back(i * side);
  write_file(folder / "hand.json", json{{"loops", {{{"points", points}}}}}.dump());
  require_done(rimline::test::rimline(
      {"reconstruct", folder / "in.ply", "-o", folder / "mesh.ply", "--use-loops", folder / "hand.json"}));
  const Ply mesh = parse_ply(read_file(folder / "mesh.ply"));
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) ++edges[std::minmax({face[i], face[(i + 1) % 3]})];
  }
  std::set<std::pair<int, int>> rim, wanted;
  for (const auto& [edge, count] : edges) {
    CHECK(count <= 2);
    if (count == 1) rim.insert(edge);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    wanted.insert(std::minmax({points[i].get<int>(), points[(i + 1) % points.size()].get<int>()}));
  }
  CHECK(rim == wanted);
}

TEST_CASE("permuting the input permutes the mesh and nothing else") {
  const Folder folder;
  auto rows = curved_square(30);
  write_file(folder / "a.ply", ply_of(rows));
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[(i * 7919 + 13) % (i + 1)]);
  std::vector<Row> permuted;
  for (const std::size_t i : order) permuted.push_back(rows[i]);
  write_file(folder / "b.ply", ply_of(permuted));
  for (const std::string name : {"a", "b"}) {
    require_done(rimline::test::rimline(
        {"reconstruct", folder / (name + ".ply"), "-o", folder / (name + "_mesh.ply")}));
    require_done(rimline::test::rimline(
        {"boundary", folder / (name + ".ply"), "-o", folder / (name + "_points.ply")}));
  }
  const Ply a = parse_ply(read_file(folder / "a_points.ply")),
            b = parse_ply(read_file(folder / "b_points.ply"));
  for (const char* name : {"boundary", "candidate", "p_value", "score"}) {
    CAPTURE(name);
    std::vector<std::string> expected;
    for (const std::size_t i : order) expected.push_back(a.raw.at(name)[i]);
    CHECK(expected == b.raw.at(name));
  }
  CHECK(triangles_in_space(parse_ply(read_file(folder / "a_mesh.ply"))) ==
        triangles_in_space(parse_ply(read_file(folder / "b_mesh.ply"))));
}

TEST_CASE("the mesh faces up, or the way that --up or the normals say") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", 1000);
  const auto faces_up = [](const Ply& mesh) {
    const auto x = mesh.values<double>("x"), y = mesh.values<double>("y");
    std::size_t up = 0;
    for (const auto& [a, b, c] : mesh.faces)
      up += (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]) > 0;
    return static_cast<double>(up) / static_cast<double>(mesh.faces.size());
  };
  require_done(rimline::test::rimline({"reconstruct", input, "-o", folder / "mesh.ply"}));
  CHECK(faces_up(parse_ply(read_file(folder / "mesh.ply"))) > 0.9);
  require_done(rimline::test::rimline({"reconstruct", input, "-o", folder / "mesh.ply", "--up", "0,0,-1"}));
  CHECK(faces_up(parse_ply(read_file(folder / "mesh.ply"))) < 0.1);
  const Ply points = parse_ply(read_file(input));
  const auto x = points.values<double>("x"), y = points.values<double>("y"), z = points.values<double>("z");
  std::string with_normals = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(x.size()) +
                             "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\n"
                             "property float ny\nproperty float nz\nend_header\n";
  for (std::size_t i = 0; i < x.size(); ++i)
    with_normals += fmt::format("{} {} {} 0 0 -1\n", x[i], y[i], z[i]);
  write_file(folder / "normals.ply", with_normals);
  require_done(rimline::test::rimline({"reconstruct", folder / "normals.ply", "-o", folder / "mesh.ply"}));
  CHECK(faces_up(parse_ply(read_file(folder / "mesh.ply"))) < 0.1);
}

TEST_CASE("every mesh format holds the same triangles") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", 500);
  for (const std::string ending : {"ply", "obj", "off", "stl"}) {
    require_done(
        rimline::test::rimline({"reconstruct", input, "-o", folder / ("mesh." + ending), "--quiet"}));
  }
  const std::size_t count = parse_ply(read_file(folder / "mesh.ply")).faces.size();
  const std::string obj = read_file(folder / "mesh.obj"), off = read_file(folder / "mesh.off");
  std::size_t faces = 0;
  for (std::size_t at = obj.find("\nf "); at != std::string::npos; at = obj.find("\nf ", at + 1)) ++faces;
  CHECK(faces == count);
  CHECK(off.starts_with("OFF"));
  CHECK(off.find(fmt::format(" {} 0\n", count)) != std::string::npos);
  CHECK(read_file(folder / "mesh.stl").size() == 84 + 50 * count);
}

TEST_CASE("every format of loops holds the same number of points") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", 500);
  for (const std::string ending : {"json", "geojson", "wkt", "csv", "ply", "obj", "dxf"}) {
    require_done(rimline::test::rimline({"boundary", input, "--loops", folder / ("loops." + ending), "-q"}));
  }
  std::size_t count = 0;
  const json loops = json::parse(read_file(folder / "loops.json")).at("loops");
  REQUIRE(loops.size() == 1);
  count = loops[0]["points"].size();
  const auto times = [&](const std::string& file, const std::string& part) {
    const std::string text = read_file(folder / file);
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  CHECK(times("loops.wkt", ",") == count);  // closed: the first is there again
  CHECK(times("loops.csv", "\n") >= count + 1);
  CHECK(times("loops.obj", "\nv ") + times("loops.obj", "#") >= count);
  CHECK(read_file(folder / "loops.ply").find(fmt::format("element edge {}\n", count)) != std::string::npos);
  CHECK(json::parse(read_file(folder / "loops.geojson")).at("type") == "FeatureCollection");
  CHECK(times("loops.dxf", "VERTEX") + times("loops.dxf", "LWPOLYLINE") > 0);
}

TEST_CASE("the report holds what its contract lists, with the options as they were used") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", 1000);
  require_done(
      rimline::test::rimline({"reconstruct", input, "-o", folder / "mesh.ply", "--report",
                              folder / "report.json", "--preset", "paper", "--k", "30", "--seed", "7"}));
  const json report = json::parse(read_file(folder / "report.json"));
  for (const char* key : {"schema", "version", "options", "seed", "points", "spacing", "candidates", "loops",
                          "search", "map", "mesh", "run"}) {
    CAPTURE(key);
    CHECK(report.contains(key));
  }
  CHECK(report["seed"] == 7);
  CHECK(report["options"]["preset"] == "paper");
  CHECK(report["options"]["score_form"] == "capped");
  CHECK(report["options"]["k"] == 30);
  CHECK(report["options"].contains("map_k"));
}

TEST_CASE("the report lists the options that counted and no others") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", 800);
  const auto options_of = [&](Names arguments) {
    arguments.insert(arguments.end(), {"--report", folder / "report.json", "--quiet"});
    require_done(rimline::test::rimline(arguments));
    return json::parse(read_file(folder / "report.json"))["options"];
  };
  const json ours = options_of({"boundary", input});
  for (const char* name : {"k", "min_loop", "rim_generations"}) CHECK(ours.contains(name));
  for (const char* name : {"path_k", "score_form", "population", "map_k", "domain", "holes"})
    CHECK_FALSE(ours.contains(name));
  const json papers = options_of({"reconstruct", input, "-o", folder / "m.ply", "--preset", "paper-log"});
  for (const char* name : {"k", "path_k", "score_form", "population", "map_k", "residual"})
    CHECK(papers.contains(name));
  for (const char* name : {"min_loop", "score_cap", "domain", "holes", "fill_points"})
    CHECK_FALSE(papers.contains(name));
}

TEST_CASE("what the search of the paper found can be seen: chromosome, history, the winner's fitness") {
  const Folder folder;
  const std::string input = sample(folder, "hemisphere-cap", 1500);
  require_done(rimline::test::rimline({"boundary", input, "-o", folder / "points.ply", "--loops",
                                       folder / "loops.json", "--report", folder / "report.json", "--history",
                                       folder / "history.json", "--preset", "paper", "--generations", "12"}));
  const json report = json::parse(read_file(folder / "report.json")), search = report["search"];
  const json history = json::parse(read_file(folder / "history.json"));
  const json loops = json::parse(read_file(folder / "loops.json"))["loops"];
  CHECK(history["points"] == report["points"]["input"]);
  CHECK(history["stride"] == 1);
  REQUIRE(history["generations"].size() == 13);
  REQUIRE(search["best_fitness"].size() == 13);
  double best = 0;
  for (std::size_t g = 0; g < 13; ++g) {
    CHECK(history["generations"][g]["generation"] == g);
    CHECK(history["generations"][g]["fitness"] == search["best_fitness"][g]);
    best = std::max(best, search["best_fitness"][g].get<double>());
  }
  CHECK(search["distinct_paths"] <= search["closed_paths"]);
  CHECK(search["population"] <= search["distinct_paths"]);
  CHECK(search["loop_from"] == "fittest chromosome");
  CHECK(search["winner_fitness"].get<double>() == doctest::Approx(best));
  CHECK(search["winner_fitness"] != loops[0]["fitness"]);  // the loop leaves points of the winner out
  CHECK(loops[0]["probability"].is_null());
  CHECK(report["loops"][0]["probability"].is_null());
  const Ply points = parse_ply(read_file(folder / "points.ply"));
  const auto chromosome = points.values<std::uint8_t>("chromosome");
  CHECK(std::count(chromosome.begin(), chromosome.end(), 1) == search["winner_points"]);
  for (const std::size_t id : loops[0]["points"]) CHECK(chromosome.at(id) == 1);
}

TEST_CASE("the default has no chromosome, and its loops have a probability") {
  const Folder folder;
  const std::string input = sample(folder, "hemisphere-cap", 1500);
  require_done(rimline::test::rimline(
      {"boundary", input, "-o", folder / "points.ply", "--loops", folder / "loops.json"}));
  CHECK(read_file(folder / "points.ply").find("chromosome") == std::string::npos);
  CHECK(json::parse(read_file(folder / "loops.json"))["loops"][0]["probability"].is_number());
}

TEST_CASE("a flag beats the preset, wherever it stands") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", 500);
  for (const Names& order : {Names{"--score-form", "log", "--preset", "paper"},
                             Names{"--preset", "paper", "--score-form", "log"}}) {
    Names arguments = {"boundary", input, "--report", folder / "report.json"};
    arguments.insert(arguments.end(), order.begin(), order.end());
    require_done(rimline::test::rimline(arguments));
    CHECK(json::parse(read_file(folder / "report.json"))["options"]["score_form"] == "log");
  }
}

TEST_CASE("sample writes its points with their truth") {
  const Folder folder;
  require_done(rimline::test::rimline(
      {"sample", "square-with-holes", "-n", "2000", "-o", folder / "s.ply", "--truth", folder / "t.json"}));
  const Ply points = parse_ply(read_file(folder / "s.ply"));
  const auto boundary = points.values<std::uint8_t>("boundary");
  std::vector<std::uint8_t> on_loop(points.vertices, 0);
  const json loops = json::parse(read_file(folder / "t.json")).at("loops");
  CHECK(loops.size() == 4);
  for (const json& loop : loops) {
    for (const std::size_t id : loop["points"]) on_loop.at(id) = 1;
  }
  CHECK(on_loop == boundary);
  const Finished again = rimline::test::rimline({"sample", "square-with-holes", "-n", "2000", "-o", "-"});
  CHECK(again.out == read_file(folder / "s.ply"));
}

TEST_CASE("info counts points, properties, duplicates and rows that are not finite") {
  const Folder folder;
  auto rows = curved_square(30);
  rows.push_back(rows[7]);
  rows.push_back({std::nan(""), 0, 0, 1, 2, 3, 4, 0});
  write_file(folder / "in.ply", ply_of(rows));
  const Finished info = rimline::test::rimline({"info", folder / "in.ply"});
  require_done(info);
  const auto line = [&](const std::string& label) {
    const std::size_t at = info.out.find("\n" + label + " ");
    if (at == std::string::npos) return std::string("no line " + label);
    std::string text =
        info.out.substr(at + 1 + label.size(), info.out.find('\n', at + 1) - at - 1 - label.size());
    return text.substr(text.find_first_not_of(' '));
  };
  CHECK(line("format") == "PLY, binary little-endian");
  CHECK(line("points") == "902");
  CHECK(line("duplicates") == "1");
  CHECK(line("not finite") == "1");
  CHECK(line("coordinates") == "double");
  CHECK(line("properties") == "uchar red, uchar green, uchar blue, float intensity, uchar boundary");
  CHECK(line("x") == "1000000 to 1000000.029");
}

TEST_CASE("pictures are whole PNG and SVG files") {
  const Folder folder;
  const std::string input = sample(folder, "hemisphere-cap", 1000);
  for (const std::string name : {"p.png", "p.svg"}) {
    require_done(rimline::test::rimline(
        {"reconstruct", input, "-o", folder / "mesh.ply", "--picture", folder / name}));
  }
  const std::string png = read_file(folder / "p.png"), svg = read_file(folder / "p.svg");
  CHECK(png.starts_with("\x89PNG"));
  CHECK(png.substr(png.size() - 8, 4) == "IEND");
  CHECK(svg.find("<svg") != std::string::npos);
  CHECK(svg.ends_with("</svg>\n"));
}

TEST_CASE("every key of REPORT.json is in docs/formats.md, and every stage has its seconds and memory") {
  const Folder folder;
  const std::string input = sample(folder, "hemisphere-cap", 600);
  std::string text = read_file(RIMLINE_SOURCE "/docs/formats.md");
  text = text.substr(text.find("## REPORT.json"));
  for (const std::string preset : {"default", "paper"}) {
    require_done(rimline::test::rimline({"reconstruct", input, "-o", folder / "mesh.ply", "--preset", preset,
                                         "--report", folder / "report.json", "--quiet"}));
    const json report = json::parse(read_file(folder / "report.json"));
    const auto documented = [&](const std::string& key) {
      return text.find("`" + key + "`") != std::string::npos ||
             text.find("." + key + "`") != std::string::npos ||
             text.find("`" + key + "[]`") != std::string::npos ||
             text.find("." + key + "[]`") != std::string::npos;
    };
    const std::function<void(const json&)> visit = [&](const json& part) {
      if (part.is_array() && !part.empty()) visit(part.front());
      if (!part.is_object()) return;
      for (const auto& [key, value] : part.items()) {
        CAPTURE(key);
        if (!value.is_object()) CHECK(documented(key));
        if (key != "options") visit(value);
      }
    };
    visit(report);
    std::set<std::string> stages;
    for (const json& stage : report.at("run").at("stages")) {
      stages.insert(stage.at("stage").get<std::string>());
      CHECK(stage.at("seconds").get<double>() >= 0);
      CHECK(stage.at("peak_bytes").get<double>() > 1e6);
    }
    for (const std::string stage :
         {"read", "arrange", "neighbours", "boundary", "loops", "measure", "write"}) {
      CAPTURE(stage);
      CHECK(stages.contains(stage));
    }
    CHECK(stages.contains("survey") == (preset == "default"));
  }
}

TEST_CASE("the progress bar shows stages on a terminal only, and is gone at the end") {
  const Folder folder;
  const std::string input = sample(folder, "hemisphere-cap", 2000);
  const Names arguments = {"reconstruct", input, "-o", folder / "mesh.ply"};
  const Finished shown = run({.arguments = arguments, .terminal = true});
  require_done(shown);
  CHECK(shown.err.find("neighbours") != std::string::npos);
  CHECK(shown.err.find("loops") != std::string::npos);
  CHECK(shown.err.ends_with("\r\033[K"));
  CHECK(run({.arguments = arguments}).err.empty());
  Names quiet = arguments;
  quiet.push_back("--quiet");
  const Finished silent = run({.arguments = quiet, .terminal = true});
  CHECK(silent.err.empty());
  CHECK(silent.out.empty());
}
