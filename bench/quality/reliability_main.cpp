// SPDX-License-Identifier: GPL-3.0-or-later
// rimline_reliability: how often a mesh comes out, and is one, beside the peers. bench/README.md
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "base/parallel.h"
#include "quality/pages.h"
#include "quality/questions.h"
#include "quality/table.h"
#include "quality/validity.h"

namespace {

using namespace rimline::bench;

struct Settings {
  std::string data, methods = "default,co3ne,advancing-front,greedy-projection";
  std::uint64_t seed = 1;
  std::size_t clouds = 1000, peer_clouds = 200, every = 1, most_points = 50'000;
  int draws = 20, jobs = 2;
  std::string markdown, commit = "unknown";
  bool faults = false;
};

// What came of one question.
struct Answer {
  bool refused = false, right = false, with_truth = false, topology = false;
  std::string fault;
  std::size_t points = 0;
  double unused = 0;  // points in no triangle
};

Answer ask(const Method& method, const Asked& asked) {
  const Outcome outcome = method.run(asked.points, true);
  const std::size_t points = asked.points.points.size();
  Answer answer;
  answer.refused = outcome.mesh.empty();
  answer.fault = answer.refused ? outcome.error + outcome.mesh_error : fault_in(outcome, points);
  answer.right = answer.refused ? !asked.has_surface : answer.fault.empty();
  answer.points = points;
  answer.with_truth = asked.truth.has_value();
  if (answer.refused) return answer;
  answer.unused = share_unused(outcome.mesh, points) * static_cast<double>(points);
  answer.topology = asked.truth && topology_of(outcome.mesh) == *asked.truth;
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

std::vector<Question> questions_of(const Settings& settings) {
  std::vector<Question> questions = questions_of_files(settings.data);
  for (Question& q : questions_of_clouds(settings.seed, settings.clouds)) questions.push_back(std::move(q));
  for (Question& q : questions_of_shapes(settings.seed, settings.draws)) questions.push_back(std::move(q));
  std::vector<Question> chosen;
  for (std::size_t q = 0; q < questions.size(); q += settings.every)
    chosen.push_back(std::move(questions[q]));
  return chosen;
}

// Peers are asked about fewer of the clouds.
bool is_asked(const Settings& settings, const Method& method, const Question& question) {
  const bool is_cloud = question.path.empty() && question.sample.n == 0;
  return method.is_default || !is_cloud || question.number < settings.peer_clouds;
}

// By question and method; none where it was not asked, or the question is no point set or too large.
using Answers = std::vector<std::vector<std::optional<Answer>>>;

Answers answer_all(const Settings& settings, const std::vector<Question>& questions,
                   const std::vector<Method>& methods) {
  Answers answers(questions.size(), std::vector<std::optional<Answer>>(methods.size()));
  rimline::Run pool;
  pool.threads = settings.jobs;
  const auto answer = [&](std::size_t q) {
    const Asked asked = ask_for(questions[q]);
    if (asked.points.points.size() > settings.most_points) return;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (is_asked(settings, methods[m], questions[q])) answers[q][m] = ask(methods[m], asked);
    }
  };
  rimline::parallel_slices(
      questions.size(), rimline::Stage::Measure, pool,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = begin; q < end; ++q) {
          try {
            answer(q);
          } catch (const rimline::Error& error) {
            fmt::print(stderr, "{}: {}\n", questions[q].name, error.what());  // is no point set
          }
        }
      },
      1);
  return answers;
}

void print_faults(const std::vector<Question>& questions, const std::vector<Method>& methods,
                  const Answers& answers) {
  for (std::size_t q = 0; q < questions.size(); ++q) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const std::optional<Answer>& a = answers[q][m];
      if (!a || (a->right && (!a->with_truth || a->topology))) continue;
      fmt::print("{} {} {}: {}\n", questions[q].group, questions[q].name, methods[m].id,
                 a->right ? "topology" : a->fault);
    }
  }
}

std::string table_of(const std::vector<Question>& questions, const std::vector<Method>& methods,
                     const Answers& answers) {
  std::map<std::string, std::vector<std::vector<Answer>>> groups;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    auto& group = groups[questions[q].group];
    group.resize(methods.size());
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (answers[q][m]) group[m].push_back(*answers[q][m]);
    }
  }
  Table table({"files", "method", "count", "valid", "invalid", "refused", "right", "topology right",
               "points in no triangle"});
  for (const auto& [group, by_method] : groups) {
    for (std::size_t m = 0; m < methods.size(); ++m) table.add(row_of(group, methods[m].title, by_method[m]));
  }
  return table.markdown();
}

void write_page(const Settings& settings, const std::string& table) {
  std::ofstream page(settings.markdown);
  page << fmt::format(
      "# Reliability\n\nHow often a mesh comes out, and is one, beside what people use today on the same "
      "files. Written by\n"
      "`bench/quality/reliability`; what the columns mean is in "
      "[bench/README.md](../bench/README.md#reliability). Peers are "
      "asked\nabout the first {} clouds alone; files of more than {} points are left out, and `--every` asks "
      "about "
      "one in so many.\n\n"
      "| command | commit |\n|---|---|\n"
      "| `bench/quality/reliability --seed {} --clouds {} --peer-clouds {} --draws {} --every {} "
      "--most-points {}` "
      "| {} |\n\n",
      settings.peer_clouds, settings.most_points, settings.seed, settings.clouds, settings.peer_clouds,
      settings.draws, settings.every, settings.most_points, settings.commit);
  page << table;
  if (!page.flush()) throw std::runtime_error(settings.markdown + ": can not be written");
}

void run(const Settings& settings) {
  const std::vector<Question> questions = questions_of(settings);
  const std::vector<Method> methods = methods_of(settings);
  const Answers answers = answer_all(settings, questions, methods);
  if (settings.faults) print_faults(questions, methods, answers);
  const std::string table = table_of(questions, methods, answers);
  std::fputs(table.c_str(), stdout);
  if (!settings.markdown.empty()) write_page(settings, table);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Counts meshes that are valid, invalid and refused, of rimline and its peers."};
  Settings settings;
  app.add_option("--data", settings.data, "folders of point sets, parted by ':'")->envname("RIMLINE_DATA");
  app.add_option("--seed", settings.seed, "of the hard clouds")->capture_default_str();
  app.add_option("--clouds", settings.clouds, "how many of them")->capture_default_str();
  app.add_option("--peer-clouds", settings.peer_clouds, "of them for the peers")->capture_default_str();
  app.add_option("--every", settings.every, "of files, clouds and shapes one in so many")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--draws", settings.draws, "of each shape that is no disc, at noise 0, 0.2 and 0.5")
      ->capture_default_str();
  app.add_option("--markdown", settings.markdown, "write the page");
  app.add_option("--commit", settings.commit, "that the page names");
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
