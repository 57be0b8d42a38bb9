// SPDX-License-Identifier: GPL-3.0-or-later
// Each question starts the peer's program anew (peers/protocol.h), under a limit of time.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "peers/protocol.h"
#include "quality/method.h"

extern char** environ;

namespace rimline::bench {
namespace {

namespace fs = std::filesystem;

struct Peer {
  const char *program, *method, *id, *title;
  bool finds_boundary, makes_mesh;
};

constexpr Peer all_peers[] = {
    {"rimline_peer_pcl", "boundary-30-90", "pcl-30-90", "PCL k=30, 90°", true, false},
    {"rimline_peer_pcl", "boundary-40-90", "pcl-40-90", "PCL k=40, 90°", true, false},
    {"rimline_peer_pcl", "boundary-40-120", "pcl-40-120", "PCL k=40, 120°", true, false},
    {"rimline_peer_cgal", "advancing-front", "advancing-front", "CGAL advancing front", true, true},
    {"rimline_peer_cgal", "scale-space-alpha", "scale-space-alpha", "CGAL scale space + alpha", false, true},
    {"rimline_peer_cgal", "scale-space-advancing-front", "scale-space-front", "CGAL scale space + front",
     false, true},
    {"rimline_peer_pcl", "greedy-projection", "greedy-projection", "PCL greedy projection", false, true},
    {"rimline_peer_geogram", "co3ne", "co3ne", "geogram Co3Ne", false, true},
    {"rimline_peer_geogram", "co3ne-no-fill", "co3ne-no-fill", "Co3Ne, no fill", false, true},
};

constexpr const char* time_limit = "900";  // seconds

// A folder of our own, gone when it goes.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static std::atomic<int> count{0};
    path_ = fs::temp_directory_path() /
            ("rimline_quality_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    fs::create_directory(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

// The exit status, 128 and more for a signal; 124 when the time was up.
int run_program(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", 1, 0);
  posix_spawn_file_actions_addopen(&quiet, STDERR_FILENO, "/dev/null", 1, 0);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, argv[0], &quiet, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&quiet);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) != child) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string reason(int status) {
  if (status == 124) return std::string("did not end within ") + time_limit + " s";
  if (status >= 128) return "crashed with signal " + std::to_string(status - 128);
  return "failed with status " + std::to_string(status);
}

std::vector<Index> boundary_vertices(const std::vector<Triangle>& mesh) {
  std::vector<Index> ids;
  for (const Edge& e : boundary_of(edges_of_mesh(mesh))) ids.insert(ids.end(), {e.a, e.b});
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void write_points(const std::string& path, const std::vector<Point>& points) {
  peers::Coordinates coordinates;
  for (const Point& p : points) coordinates.push_back({p.x, p.y, p.z});
  std::ofstream out(path, std::ios::binary);
  peers::write_array(out, coordinates);
}

Outcome ask(const std::string& program, const Peer& peer, const Case& c) {
  const TemporaryFolder folder;
  const std::string in = folder.file("points"), out = folder.file("answer");
  write_points(in, c.points);
  Outcome outcome;
  const int status = run_program({"timeout", time_limit, program, peer.method, in, out});
  if (status != 0) {
    outcome.error = reason(status);
    return outcome;
  }
  peers::Answer answer = peers::read_answer(out);
  outcome.seconds = answer.seconds;
  outcome.boundary = std::move(answer.boundary);
  outcome.mesh = std::move(answer.triangles);
  if (peer.makes_mesh) outcome.boundary = boundary_vertices(outcome.mesh);
  return outcome;
}

}  // namespace

std::vector<Method> peer_methods() {
  std::vector<Method> methods;
  for (const Peer& peer : all_peers) {
    const std::string program = std::string(RIMLINE_PEER_FOLDER) + "/" + peer.program;
    if (!fs::exists(program)) continue;
    Method& method = methods.emplace_back();
    method.id = peer.id;
    method.title = peer.title;
    method.finds_boundary = peer.finds_boundary;
    method.makes_mesh = peer.makes_mesh;
    method.run = [program, peer](const Case& c, bool) { return ask(program, peer, c); };
  }
  return methods;
}

}  // namespace rimline::bench
