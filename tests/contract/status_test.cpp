// SPDX-License-Identifier: GPL-3.0-or-later
// Each exit status, provoked, and what is left on the disk when it comes.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "../mesh_rules.h"
#include "ply.h"
#include "rimline/memory.h"
#include "tool.h"

using namespace rimline::test;
using Names = std::vector<std::string>;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string sample(const Folder& folder, const std::string& shape, const std::string& n) {
  const std::string path = folder / "sample.ply";
  const Finished done =
      rimline::test::rimline({"sample", shape, "-n", n, "--sampling", "random", "-o", path, "--quiet"});
  REQUIRE(done.status == 0);
  return path;
}

// A square grid of side * side points, `dx` to the right.
std::string grid(int side, double dx) {
  std::string text;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) text += fmt::format("{} {} 0\n", x + dx, y);
  }
  return text;
}

// The loop around grid(side, 0).
std::string rim_of_grid(int side) {
  nlohmann::json points = nlohmann::json::array();
  for (int i = 0; i < side - 1; ++i) points.push_back(i);
  for (int i = 0; i < side - 1; ++i) points.push_back(i * side + side - 1);
  for (int i = side - 1; i > 0; --i) points.push_back((side - 1) * side + i);
  for (int i = side - 1; i > 0; --i) points.push_back(i * side);
  return nlohmann::json{{"schema", 1}, {"loops", {{{"points", points}}}}}.dump();
}

}  // namespace

TEST_CASE("status 2: an input that can not be read is named, and nothing is written") {
  const Folder folder;
  write_file(folder / "words.txt", "this is not a point\n");
  write_file(folder / "empty.ply", "");
  write_file(folder / "cut.ply",
             "ply\nformat binary_little_endian 1.0\nelement vertex 1000\nproperty float x\nproperty float y\n"
             "property float z\nend_header\nabc");
  write_file(folder / "row.xyz", "0 0 0\n1 0 0\n0 one 0\n");
  for (const std::string name : {"missing.ply", "words.txt", "empty.ply", "cut.ply", "row.xyz"}) {
    const Finished refused =
        rimline::test::rimline({"reconstruct", folder / name, "-o", folder / "mesh.ply", "--quiet"});
    CAPTURE(refused.err);
    CHECK(refused.status == 2);
    CHECK(refused.out.empty());
    CHECK(contains(refused.err, folder / name));
  }
  CHECK(contains(rimline::test::rimline({"info", folder / "row.xyz"}).err, "3"));  // the line
  CHECK(folder.names() == Names{"cut.ply", "empty.ply", "row.xyz", "words.txt"});
}

TEST_CASE("status 2: a boundary made by hand that is no boundary of these points") {
  const Folder folder;
  write_file(folder / "grid.xyz", grid(12, 0));
  for (const std::string text : {"{\"loops\": [{\"points\": [0, 1, 5000]}]}",
                                 "{\"loops\": [{\"points\": [0]}]}", "{\"loops\": 7}", "{"}) {
    write_file(folder / "loops.json", text);
    const Finished refused =
        rimline::test::rimline({"reconstruct", folder / "grid.xyz", "-o", folder / "mesh.ply", "--use-loops",
                                folder / "loops.json"});
    CAPTURE(refused.err);
    CHECK(refused.status == 2);
    CHECK(contains(refused.err, "loops.json"));
  }
  CHECK(folder.names() == Names{"grid.xyz", "loops.json"});
}

TEST_CASE("status 3: too few points") {
  const Folder folder;
  write_file(folder / "one.xyz", "1 2 3\n");
  const Finished refused =
      rimline::test::rimline({"reconstruct", folder / "one.xyz", "-o", folder / "mesh.ply"});
  CHECK(refused.status == 3);
  CHECK(folder.names() == Names{"one.xyz"});
}

TEST_CASE("status 3: points on a line are no surface, under every preset") {
  const Folder folder;
  std::string even, uneven;
  for (int i = 0; i < 300; ++i) {
    even += fmt::format("{} {} {}\n", 0.1 * i, 0.2 * i, 7);
    uneven += fmt::format("{0} {0} {1}\n", 1e-3 * i * i + 5, 1e-10 * (i % 7));
  }
  write_file(folder / "even.xyz", even);
  write_file(folder / "uneven.xyz", uneven);
  for (const std::string name : {"even.xyz", "uneven.xyz"}) {
    for (const std::string preset : {"default", "paper", "paper-log"}) {
      const Finished refused = rimline::test::rimline(
          {"reconstruct", folder / name, "-o", folder / "mesh.ply", "--preset", preset});
      CAPTURE(preset);
      CAPTURE(refused.err);
      CHECK(refused.status == 3);
      CHECK(contains(refused.err, "on a line"));
    }
  }
  CHECK(folder.names() == Names{"even.xyz", "uneven.xyz"});
}

TEST_CASE("status 3: points that no chain of neighbours joins to the loop are counted and named") {
  const Folder folder;
  write_file(folder / "two.xyz", grid(12, 0) + grid(12, 1000));
  write_file(folder / "loops.json", rim_of_grid(12));
  const Finished refused =
      rimline::test::rimline({"reconstruct", folder / "two.xyz", "-o", folder / "mesh.ply", "--use-loops",
                              folder / "loops.json", "--preset", "paper"});
  CAPTURE(refused.err);
  CHECK(refused.status == 3);
  CHECK(contains(refused.err, "(144 points: 144, 145, 146, 147, 148, 149, 150, 151, 152, 153, ...)"));
  CHECK(folder.names() == Names{"loops.json", "two.xyz"});
}

TEST_CASE("a closed surface has no loops, and a mesh that faces outward, with a map of two charts") {
  const Folder folder;
  const std::string input = sample(folder, "closed-sphere", "2000");
  const Finished none = rimline::test::rimline({"boundary", input, "--loops", folder / "loops.json"});
  CHECK(none.status == 0);
  CHECK(nlohmann::json::parse(read_file(folder / "loops.json")).at("loops").empty());
  CHECK(contains(none.out, "none: the surface is closed"));
  CHECK_FALSE(contains(none.out, "warning"));
  const Finished done = rimline::test::rimline(
      {"reconstruct", input, "-o", folder / "mesh.ply", "--report", folder / "report.json"});
  CAPTURE(done.err);
  REQUIRE(done.status == 0);
  CHECK(contains(done.out, "closed"));
  const auto report = nlohmann::json::parse(read_file(folder / "report.json"));
  CHECK(report.at("mesh").at("euler_number") == 2);
  CHECK(report.at("map").at("kind") == nlohmann::json{"free"});
  CHECK(report.at("map").at("charts") == 2);
  CHECK(report.at("components").at(0).at("shape") == "closed");
  const Ply mesh = parse_ply(read_file(folder / "mesh.ply"));
  CHECK(broken_rule(mesh.faces, static_cast<int>(mesh.vertices)) == "");
  CHECK(rim_of(mesh.faces).empty());
  const auto u = mesh.values<double>("u");
  REQUIRE(mesh.texcoord.size() == mesh.faces.size());
  for (std::size_t t = 0; t < mesh.faces.size(); ++t) {
    const auto& c = mesh.texcoord[t];
    CHECK((c[2] - c[0]) * (c[5] - c[1]) - (c[3] - c[1]) * (c[4] - c[0]) > 0);
    for (int i = 0; i < 3; ++i) CHECK((std::isnan(u[mesh.faces[t][i]]) || u[mesh.faces[t][i]] == c[2 * i]));
  }
}

TEST_CASE("status 3: where no triangle can be given, loops and report are written all the same") {
  const Folder folder;
  std::string line;
  for (int i = 0; i < 50; ++i) line += fmt::format("{} 0 0\n", i);
  write_file(folder / "line.xyz", line);
  const Finished refused =
      rimline::test::rimline({"reconstruct", folder / "line.xyz", "-o", folder / "mesh.ply", "--loops",
                              folder / "loops.json", "--report", folder / "report.json"});
  CHECK(refused.status == 3);
  CHECK(folder.names() == Names{"line.xyz", "loops.json", "report.json"});
  CHECK(nlohmann::json::parse(read_file(folder / "loops.json")).at("loops").empty());
  CHECK_FALSE(nlohmann::json::parse(read_file(folder / "report.json")).at("warnings").empty());
}

TEST_CASE("parts that no loop of a file bounds are listed, and are status 3 under --strict") {
  const Folder folder;
  write_file(folder / "two.xyz", grid(12, 0) + grid(12, 1000));
  write_file(folder / "loops.json", rim_of_grid(12));
  std::vector<std::string> call{"reconstruct", folder / "two.xyz",    "-o",       folder / "mesh.ply",
                                "--use-loops", folder / "loops.json", "--report", folder / "report.json"};
  for (const std::string flag : {"", "--allow-partial"}) {
    std::vector<std::string> arguments = call;
    if (!flag.empty()) arguments.push_back(flag);
    const Finished done = rimline::test::rimline(arguments);
    CAPTURE(done.err);
    CHECK(done.status == 0);
    CHECK(contains(done.err, "--allow-partial") == !flag.empty());
    const auto left_out = nlohmann::json::parse(read_file(folder / "report.json")).at("left_out");
    REQUIRE(left_out.size() == 1);
    CHECK(left_out[0].at("points") == 144);
    CHECK(left_out[0].at("ids").at(0) == 144);
    CHECK(left_out[0].at("box").at(0).at(0) == 1000);
    for (const char* key : {"cause", "try"}) CHECK_FALSE(left_out[0].at(key).empty());
  }
  call.push_back("--strict");
  const Finished refused = rimline::test::rimline(call);
  CHECK(refused.status == 3);
  CHECK(contains(refused.err, "144 points"));
}

TEST_CASE("status 4: a folder that is not there, or that takes no files") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", "300");
  for (const std::string& path : {folder / "no/mesh.ply", std::string("/proc/mesh.ply")}) {
    const Finished refused = rimline::test::rimline({"reconstruct", input, "-o", path});
    CAPTURE(refused.err);
    CHECK(refused.status == 4);
    CHECK(contains(refused.err, path));
  }
}

TEST_CASE("status 4: a full disk leaves no partial file") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", "2000");
  const Finished refused =
      run({.arguments = {"boundary", input, "-o", folder / "points.ply", "--quiet"}, .file_size = 20'000});
  CAPTURE(refused.err);
  CHECK(refused.status == 4);
  CHECK(contains(refused.err, folder / "points.ply"));
  CHECK(contains(refused.err, "; raise the limit on the size of files"));
  CHECK(folder.names() == Names{"sample.ply"});
}

TEST_CASE("links that lead to themselves are named, with what to do") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", "300"), link = folder / "link.ply";
  std::filesystem::create_symlink("link.ply", link);
  const Finished written = rimline::test::rimline({"reconstruct", input, "-o", link, "--quiet"});
  CHECK(written.status == 4);
  CHECK(
      contains(written.err, "link.ply: cannot be written: Too many levels of symbolic links; name the file"));
  const Finished read = rimline::test::rimline({"info", link});
  CHECK(read.status == 2);
  CHECK(contains(read.err, "link.ply: cannot be opened: Too many levels of symbolic links; check the path"));
}

TEST_CASE("status 4: standard output that takes nothing") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", "2000");
  CHECK(run({.arguments = {"boundary", input, "-o", "-"}, .output_to = "/dev/full"}).status == 4);
  CHECK(run({.arguments = {"info", input}, .output_to = "/dev/full"}).status == 4);
  CHECK(run({.arguments = {"--help"}, .output_to = "/dev/full"}).status == 4);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they reserve terabytes of addresses
TEST_CASE("status 4: out of memory") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", "300000");
  const Finished refused =
      run({.arguments = {"boundary", input, "-o", folder / "points.ply", "--threads", "1"},
           .memory = std::size_t{100} << 20});
  CAPTURE(refused.err);
  CHECK(refused.status == 4);
  CHECK(contains(refused.err, "memory"));
  CHECK(folder.names() == Names{"sample.ply"});
}
#endif

TEST_CASE(
    "status 4: what would need more memory than the limit is refused with the estimate, before it starts") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", "20000");
  const std::string mesh = folder / "mesh.ply", report = folder / "report.json";
  const auto refused = rimline::test::rimline({"reconstruct", input, "-o", mesh, "--memory-limit", "30M"});
  CHECK(refused.status == 4);
  CHECK(contains(refused.err, "20000 points need about"));
  CHECK(contains(refused.err, "the limit is 0.03 GB"));
  CHECK(folder.names() == Names{"sample.ply"});
  const auto file = rimline::test::rimline({"info", input, "--memory-limit", "1k"});
  CHECK(file.status == 4);
  CHECK(contains(file.err, "sample.ply"));
  const auto done =
      rimline::test::rimline({"reconstruct", input, "-o", mesh, "--report", report, "--memory-limit", "1G"});
  CHECK(done.status == 0);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they take memory of their own
TEST_CASE("no stage takes more memory than its estimate, nor half of it") {
  const Folder folder;
  const std::string input = sample(folder, "sphere-minus-cap", "50000"), report = folder / "report.json";
  for (const Names& more : {Names{}, Names{"--k", "60"}}) {
    Names arguments{"reconstruct", input, "-o", folder / "mesh.ply", "--report", report};
    arguments.insert(arguments.end(), more.begin(), more.end());
    REQUIRE(rimline::test::rimline(arguments).status == 0);
    rimline::Options options;
    if (!more.empty()) options.boundary.k = 60;
    const auto told = nlohmann::json::parse(read_file(report));
    for (const auto& stage : told["run"]["stages"]) {
      CAPTURE(stage.dump());
      for (const auto& estimate : rimline::estimate_memory(50'000, options)) {
        if (name(estimate.stage) != stage["stage"].get<std::string>()) continue;
        const auto peak = stage["peak_bytes"].get<std::size_t>();
        CHECK(peak <= estimate.bytes);
        CHECK(2 * peak >= estimate.bytes);
      }
    }
  }
}
#endif

TEST_CASE("status 5: Ctrl-C while a stage runs ends it and leaves no file") {
  const Folder folder;
  const std::string input = sample(folder, "bumpy-square", "200000");
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const std::string stage : {"neighbours", "boundary", "survey", "loops"}) {
      const Finished stopped = run(
          {.arguments = {"reconstruct", input, "-o", folder / "mesh.ply", "--loops", folder / "loops.json"},
           .terminal = true,
           .signal = signal,
           .signal_when = [&](const std::string& err, bool) { return contains(err, stage); }});
      CAPTURE(stage);
      CAPTURE(stopped.err);
      CHECK(stopped.status == 5);
      CHECK(contains(stopped.err, "rimline: interrupted"));
      CHECK(folder.names() == Names{"sample.ply"});
    }
  }
}

// That each stage stops before the next begins is a test of tests/pipeline: here a busy machine may deliver
// the signal a stage later. The mesh is not read before, so that the tool is still there.
TEST_CASE("status 5: Ctrl-C is heard without the deadline") {
  const Folder folder;
  const std::string input = sample(folder, "bumpy-square", "20000");
  const auto stops = [&](const std::string& preset, const std::string& stage) {
    Names arguments = {"reconstruct", input, "-o", "-", "--loops", folder / "loops.json", "--preset", preset};
    if (preset == "paper") arguments.insert(arguments.end(), {"--max-path-steps", "5000000"});
    const Finished stopped =
        run({.arguments = arguments,
             .terminal = true,
             .hold_output = true,
             .signal = SIGINT,
             .deadline = false,
             .signal_when = [&](const std::string& err, bool) { return contains(err, "\033[K" + stage); }});
    CAPTURE(preset);
    CAPTURE(stage);
    CAPTURE(stopped.err);
    CHECK(folder.names() == Names{"sample.ply"});
    CHECK(stopped.status == 5);
    CHECK(contains(stopped.err, "rimline: interrupted"));
  };
  for (const std::string stage : {"neighbours", "survey", "loops", "refine", "measure"})
    stops("default", stage);
  for (const std::string stage : {"loops", "parameterize", "triangulate"}) stops("paper", stage);
}

TEST_CASE("status 5: a second Ctrl-C ends the tool at once") {
  const Folder folder;
  const std::string input = sample(folder, "bumpy-square", "60000");
  const Finished stopped =
      run({.arguments = {"reconstruct", input, "-o", folder / "mesh.obj"},
           .terminal = true,
           .signal = SIGINT,
           .signals = 2,
           .signal_when = [&](const std::string& err, bool) { return contains(err, "refine"); }});
  CAPTURE(stopped.err);
  CHECK(stopped.status == 5);
  CHECK(folder.names() == Names{"sample.ply"});
}

TEST_CASE("status 5: Ctrl-C while the tool waits for standard input") {
  const Folder folder;
  const Finished stopped =
      run({.arguments = {"reconstruct", "-", "-o", folder / "mesh.ply"},
           .input = "0 0 0\n1 0 0\n",
           .keep_input_open = true,
           .signal = SIGINT,
           .signal_when = [](const std::string&, bool input_taken) { return input_taken; }});
  CAPTURE(stopped.err);
  CHECK(stopped.status == 5);
  CHECK(folder.names().empty());
}
