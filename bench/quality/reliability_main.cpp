// SPDX-License-Identifier: GPL-3.0-or-later
// rimline_reliability: how often a mesh comes out, and is one, beside the peers. bench/README.md
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/parallel.h"
#include "quality/hard_clouds.h"
#include "quality/pages.h"
#include "quality/ply_faces.h"
#include "quality/table.h"
#include "quality/validity.h"
#include "rimline/io.h"

namespace {

using namespace rimline::bench;
namespace fs = std::filesystem;

struct Settings {
  std::string data, methods = "default,co3ne,advancing-front,greedy-projection";
  std::uint64_t seed = 1;
  std::size_t clouds = 1000, most_points = 50'000;
  int jobs = 2;
  bool faults = false;
};

// One file or cloud.
struct Question {
  std::string group, name, path;
  std::uint64_t number = 0;  // of a hard cloud
};

// What came of one question.
struct Answer {
  bool refused = false, right = false, with_truth = false, topology = false;
  std::string fault;
  std::size_t points = 0;
  double unused = 0;  // points in no triangle
};

// The point sets below the folders, truth meshes left out; a group a folder.
std::vector<Question> files_of(const std::string& folders) {
  std::vector<Question> questions;
  std::istringstream names(folders);
  for (std::string folder; std::getline(names, folder, ':');) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      const bool is_set =
          name.ends_with(".xyz") || name.ends_with(".pcd") ||
          (name.ends_with(".ply") && !name.ends_with(".truth.ply") && !name.ends_with(".flipped.ply"));
      if (is_set) questions.push_back({fs::path(folder).filename().string(), name, entry.path().string()});
    }
  }
  std::ranges::sort(questions, {}, &Question::path);
  return questions;
}

Case case_of(const Settings& settings, const Question& question, bool& has_surface) {
  Case c;
  if (question.path.empty()) {
    HardCloud cloud = hard_cloud(settings.seed, question.number);
    has_surface = cloud.has_surface;
    c.points = std::move(cloud.points);
    return c;
  }
  has_surface = true;
  c.points = rimline::read_cloud(question.path, {}).points;
  const fs::path truth = fs::path(question.path).replace_extension(".truth.ply");
  if (fs::exists(truth)) c.mesh = read_ply_faces(truth.string());
  return c;
}

Answer ask(const Method& method, const Case& c, bool has_surface) {
  const Outcome outcome = method.run(c, true);
  Answer answer;
  answer.refused = outcome.mesh.empty();
  answer.fault = answer.refused ? outcome.error + outcome.mesh_error : fault_in(outcome, c.points.size());
  answer.right = answer.refused ? !has_surface : answer.fault.empty();
  answer.points = c.points.size();
  if (answer.refused) return answer;
  answer.unused = share_unused(outcome.mesh, c.points.size()) * static_cast<double>(c.points.size());
  answer.with_truth = !c.mesh.empty();
  answer.topology = answer.with_truth && topology_of(outcome.mesh) == topology_of(c.mesh);
  return answer;
}

std::vector<Method> methods_of(const Settings& settings) {
  std::vector<Method> all = our_methods();
  for (Method& peer : peer_methods()) all.push_back(std::move(peer));
  std::vector<Method> chosen;
  std::istringstream names(settings.methods);
  for (std::string name; std::getline(names, name, ',');) {
    const auto found = std::ranges::find(all, name, &Method::id);
    if (found == all.end()) {
      fmt::print(stderr, "rimline_reliability: {} is not built here and is left out\n", name);
    } else {
      chosen.push_back(*found);
    }
  }
  return chosen;
}

std::vector<std::string> row_of(const std::string& group, const std::string& title,
                                const std::vector<Answer>& answers) {
  std::size_t valid = 0, invalid = 0, refused = 0, right = 0, truths = 0, topology = 0, points = 0;
  double unused = 0;
  for (const Answer& a : answers) {
    refused += a.refused;
    invalid += !a.refused && !a.fault.empty();
    valid += !a.refused && a.fault.empty();
    right += a.right;
    truths += a.with_truth;
    topology += a.topology;
    unused += a.unused;
    points += a.refused ? 0 : a.points;
  }
  const auto share = [](double part, double whole) {
    return whole > 0 ? fmt::format("{:.1f} %", 100 * part / whole) : std::string("-");
  };
  const auto count = static_cast<double>(answers.size());
  return {group,
          title,
          std::to_string(answers.size()),
          share(static_cast<double>(valid), count),
          std::to_string(invalid),
          std::to_string(refused),
          share(static_cast<double>(right), count),
          truths > 0 ? fmt::format("{} of {}", topology, truths) : "-",
          share(unused, static_cast<double>(points))};
}

void run(const Settings& settings) {
  std::vector<Question> questions = files_of(settings.data);
  for (std::uint64_t i = 0; i < settings.clouds; ++i)
    questions.push_back(
        {fmt::format("hard clouds, seed {}", settings.seed), fmt::format("cloud {}", i), "", i});
  const std::vector<Method> methods = methods_of(settings);
  std::vector<std::vector<Answer>> answers(questions.size());
  rimline::Run pool;
  pool.threads = settings.jobs;
  rimline::parallel_slices(
      questions.size(), rimline::Stage::Measure, pool,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) {
          bool has_surface = false;
          try {
            const Case c = case_of(settings, questions[q], has_surface);
            if (c.points.size() > settings.most_points) continue;
            for (const Method& method : methods) answers[q].push_back(ask(method, c, has_surface));
          } catch (const rimline::Error& error) {
            fmt::print(stderr, "{}: {}\n", questions[q].name, error.what());  // is no point set
          }
        }
      },
      1);
  std::map<std::string, std::vector<std::vector<Answer>>> groups;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    auto& group = groups[questions[q].group];
    group.resize(methods.size());
    for (std::size_t m = 0; m < answers[q].size(); ++m) {
      group[m].push_back(answers[q][m]);
      if (settings.faults && !answers[q][m].right)
        fmt::print("{} {} {}: {}\n", questions[q].group, questions[q].name, methods[m].id,
                   answers[q][m].fault);
    }
  }
  Table table({"files", "method", "count", "valid", "invalid", "refused", "right", "topology right",
               "points in no triangle"});
  for (const auto& [group, by_method] : groups) {
    for (std::size_t m = 0; m < methods.size(); ++m) table.add(row_of(group, methods[m].title, by_method[m]));
  }
  std::fputs(table.markdown().c_str(), stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Counts meshes that are valid, invalid and refused, of rimline and its peers."};
  Settings settings;
  app.add_option("--data", settings.data, "folders of point sets, parted by ':'")->envname("RIMLINE_DATA");
  app.add_option("--seed", settings.seed, "of the hard clouds")->capture_default_str();
  app.add_option("--clouds", settings.clouds, "how many of them")->capture_default_str();
  app.add_option("--most-points", settings.most_points, "larger files are left out")->capture_default_str();
  app.add_option("--methods", settings.methods, "comma between them")->capture_default_str();
  app.add_option("--jobs", settings.jobs, "files at a time")->capture_default_str();
  app.add_flag("--faults", settings.faults, "also a line for each answer that is not right");
  CLI11_PARSE(app, argc, argv);
  run(settings);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "rimline_reliability: %s\n", error.what());
  return 1;
}
