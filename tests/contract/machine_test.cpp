// SPDX-License-Identifier: GPL-3.0-or-later
// A machine that refuses: no threads, no address space, no standard streams, a terminal that hangs up. And
// what stands where an output is to go.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "tool.h"

namespace fs = std::filesystem;
using namespace rimline::test;
using Names = std::vector<std::string>;

namespace {

std::string sample(const Folder& folder, const std::string& shape, const std::string& n) {
  const std::string path = folder / "sample.ply";
  REQUIRE(rimline::test::rimline({"sample", shape, "-n", n, "--sampling", "random", "-o", path, "--quiet"})
              .status == 0);
  return path;
}

struct stat status_of(const std::string& path) {
  struct stat status {};
  REQUIRE(lstat(path.c_str(), &status) == 0);
  return status;
}

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they make threads of their own
TEST_CASE("a user who may make no thread gets the same bytes from one") {
  const Folder folder;
  fs::permissions(folder / ".", fs::perms::all);
  const std::string input = sample(folder, "sphere-minus-cap", "3000");
  const Finished free = rimline::test::rimline({"reconstruct", input, "-o", folder / "free.ply"});
  REQUIRE(free.status == 0);
  for (const std::string threads : {"0", "1", "8"}) {
    const std::string mesh = folder / ("held" + threads + ".ply"), report = folder / "report.json";
    const Finished held =
        run({.arguments = {"reconstruct", input, "-o", mesh, "--threads", threads, "--report", report},
             .no_threads = true});
    if (held.status == 126 || held.status == 127) {
      MESSAGE("skipped: the user nobody can not run the tool");
      return;
    }
    CAPTURE(threads);
    CAPTURE(held.err);
    REQUIRE(held.status == 0);
    CHECK(read_file(mesh) == read_file(folder / "free.ply"));
    CHECK(nlohmann::json::parse(read_file(report))["run"]["threads"] == 1);
  }
}

// They also reserve terabytes of addresses.
TEST_CASE("whatever the address space, the tool ends with the same bytes or with status 4") {
  const Folder folder;
  const std::string input = sample(folder, "sphere-minus-cap", "2000");
  REQUIRE(rimline::test::rimline({"reconstruct", input, "-o", folder / "free.ply", "--quiet"}).status == 0);
  int done = 0, refused = 0;
  for (std::size_t megabytes = 16; megabytes <= 96; megabytes += 4) {
    const std::string mesh = folder / "held.ply";
    const Finished held = run({.arguments = {"reconstruct", input, "-o", mesh}, .memory = megabytes << 20});
    if (held.status == 127) continue;  // not even the libraries fit
    CAPTURE(megabytes);
    CAPTURE(held.err);
    CHECK((held.status == 0 || held.status == 4));
    if (held.status == 0) CHECK(read_file(mesh) == read_file(folder / "free.ply"));
    (held.status == 0 ? done : refused) += 1;
    if (held.status == 0) fs::remove(mesh);
    CHECK(folder.names() == Names{"free.ply", "sample.ply"});
  }
  CHECK(done > 0);
  CHECK(refused > 0);
}
#endif

TEST_CASE("info gives the spacing in any unit") {
  const Folder folder;
  for (const std::string unit : {"e0", "e200", "e-250"}) {
    std::string text;
    for (int i = 0; i < 400; ++i) {
      text += std::to_string(1 + i % 20) + unit + " " + std::to_string(1 + i / 20) + unit + " 0\n";
    }
    write_file(folder / "grid.xyz", text);
    const std::string said = rimline::test::rimline({"info", folder / "grid.xyz"}).out;
    const std::size_t at = said.find("median ");
    REQUIRE(at != std::string::npos);
    const double median = std::stod(said.substr(at + 7));
    CHECK(median / std::stod("1" + unit) == doctest::Approx(1.138).epsilon(0.001));  // (4 + 2 sqrt 2) / 6
  }
}

TEST_CASE("with its standard streams closed the tool writes the same files, and nothing into them") {
  const Folder folder;
  const std::string input = sample(folder, "flat-disc", "2000");
  const auto arguments = [&](const std::string& name) {
    return Names{"reconstruct", input,
                 "-o",          folder / (name + ".ply"),
                 "--loops",     folder / (name + ".json"),
                 "--picture",   folder / (name + ".svg")};
  };
  REQUIRE(rimline::test::rimline(arguments("open")).status == 0);
  REQUIRE(run({.arguments = arguments("closed"), .closed_streams = true}).status == 0);
  for (const std::string ending : {".ply", ".json", ".svg"}) {
    CHECK(read_file(folder / ("closed" + ending)) == read_file(folder / ("open" + ending)));
  }
  CHECK(run({.arguments = {"info", input}, .closed_streams = true}).status == 4);
  CHECK(run({.arguments = {"boundary", input, "-o", "-"}, .closed_streams = true}).status == 4);
  CHECK(run({.arguments = {"info", "-"}, .closed_streams = true}).status == 2);
  CHECK(run({.arguments = {"info", "--no-such-flag"}, .closed_streams = true}).status == 1);
  CHECK(
      run({.arguments = {"sample", "flat-disc", "-n", "50", "-o", folder / "s.ply"}, .closed_streams = true})
          .status == 0);
}

TEST_CASE(
    "a terminal that hangs up and a limit of CPU time leave no file, or whole ones where they were written "
    "before") {
  const Folder folder;
  const std::string input = sample(folder, "bumpy-square", "60000");
  for (const auto& [stage, signal] : std::vector<std::pair<std::string, int>>{
           {"boundary", SIGHUP}, {"boundary", SIGXCPU}, {"write", SIGHUP}}) {
    const Finished stopped =
        run({.arguments = {"reconstruct", input, "-o", folder / "mesh.ply", "--loops", folder / "loops.json"},
             .terminal = true,
             .signal = signal,
             .signals = stage == "write" ? 2 : 1,
             .signal_when = [&stage](const std::string& err, bool) {
               return err.find(stage) != std::string::npos;
             }});
    CAPTURE(stage);
    CAPTURE(stopped.err);
    if (stage == "write" && stopped.status == 0) {  // the signal came after the last file
      CHECK(folder.names() == Names{"loops.json", "mesh.ply", "sample.ply"});
      continue;
    }
    CHECK(stopped.status == 5);
    if (stage == "write" && folder.names() == Names{"mesh.ply", "sample.ply"}) {  // it came between two files
      CHECK(rimline::test::rimline({"info", folder / "mesh.ply"}).status == 0);   // a whole one
      fs::remove(folder / "mesh.ply");
    }
    CHECK(folder.names() == Names{"sample.ply"});
  }
}

TEST_CASE("an output that is a link is written where the link points, also where nothing is yet") {
  const Folder folder;
  fs::create_directory(folder / "far");
  fs::create_symlink("far/new.ply", folder / "first.ply");
  fs::create_symlink("first.ply", folder / "link.ply");
  for (int round = 0; round < 2; ++round) {  // the first makes the file, the second replaces it
    const Finished done =
        rimline::test::rimline({"sample", "flat-disc", "-n", "50", "-o", folder / "link.ply"});
    CAPTURE(done.err);
    REQUIRE(done.status == 0);
    CHECK(S_ISLNK(status_of(folder / "link.ply").st_mode));
    CHECK(S_ISLNK(status_of(folder / "first.ply").st_mode));
    CHECK(S_ISREG(status_of(folder / "far/new.ply").st_mode));
    CHECK(read_file(folder / "far/new.ply").starts_with("ply\n"));
  }
  fs::create_symlink("no/such/folder.ply", folder / "lost.ply");
  fs::create_symlink("round.ply", folder / "round.ply");
  for (const std::string name : {"lost.ply", "round.ply"}) {
    const Finished refused = rimline::test::rimline({"sample", "flat-disc", "-n", "50", "-o", folder / name});
    CAPTURE(refused.err);
    CHECK(refused.status == 4);
    CHECK(refused.err.find(name) != std::string::npos);
    CHECK(S_ISLNK(status_of(folder / name).st_mode));
  }
  const Finished same = rimline::test::rimline(
      {"sample", "flat-disc", "-n", "50", "-o", folder / "link.ply", "--truth", folder / "far/new.ply"});
  CHECK(same.status == 1);
}

TEST_CASE("a file that is written over keeps its owner and its mode") {
  const Folder folder;
  const std::string path = folder / "mesh.ply";
  write_file(path, "old");
  const bool root = getuid() == 0;
  if (root) REQUIRE(chown(path.c_str(), 1234, 4321) == 0);
  if (!root) MESSAGE("the owner is not looked at: only root can give files away");
  for (const mode_t mode : {0600U, 0664U, 0444U}) {
    if (!root && mode == 0444) continue;  // may not be written to
    REQUIRE(chmod(path.c_str(), mode) == 0);
    REQUIRE(rimline::test::rimline({"sample", "flat-disc", "-n", "50", "-o", path}).status == 0);
    CHECK(read_file(path).starts_with("ply\n"));
    CHECK((status_of(path).st_mode & 07777) == mode);
    if (root) CHECK(status_of(path).st_uid == 1234);
    if (root) CHECK(status_of(path).st_gid == 4321);
  }
  const mode_t mask = umask(0);
  umask(mask);
  REQUIRE(rimline::test::rimline({"sample", "flat-disc", "-n", "50", "-o", folder / "new.ply"}).status == 0);
  CHECK((status_of(folder / "new.ply").st_mode & 07777) == (0666 & ~mask));
}
