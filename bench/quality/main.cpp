// SPDX-License-Identifier: GPL-3.0-or-later
// rimline_quality: how good the method is, beside its presets and its peers. bench/README.md
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "quality/analytic.h"
#include "quality/data_sets.h"
#include "quality/pages.h"
#include "quality/runner.h"
#include "rimline/io.h"
#include "rimline/version.h"

namespace {

using namespace rimline::bench;
namespace fs = std::filesystem;

struct Settings {
  AnalyticPlan analytic;
  Plan plan;
  bool quick = false, no_peers = false, no_analytic = false, corpus = false;
  std::string cases, methods, out = "bench/out/quality.json", markdown, keep, tables_from, commit, date;
};

void declare(CLI::App& app, Settings& s) {
  app.add_option("--data", s.plan.data, "data folders, parted by a colon; analytic cases alone without them")
      ->envname("RIMLINE_DATA");
  app.add_option("--seed", s.analytic.seed, "every case's seed is drawn from it")->capture_default_str();
  app.add_option("--draws", s.analytic.draws, "seeds a case, for the default")->capture_default_str();
  app.add_option("--other-draws", s.plan.other_draws, "seeds a case, for all others")->capture_default_str();
  app.add_option("--mesh-draws", s.plan.mesh_draws, "seeds a case that are meshed")->capture_default_str();
  app.add_option("--mesh-points", s.plan.mesh_points, "largest data set that is meshed")
      ->capture_default_str();
  app.add_flag("--quick", s.quick,
               "the default alone, one seed, noise 0 and 0.5, 1,000 points, small data sets");
  app.add_option("--cases", s.cases, "only cases whose name has one of these parts, comma between them");
  app.add_option("--methods", s.methods, "only these methods, comma between them");
  app.add_flag("--no-peers", s.no_peers, "rimline and its presets alone");
  app.add_flag("--no-analytic", s.no_analytic, "data sets alone");
  app.add_flag("--corpus", s.corpus, "the sets of a corpus alone, with the page of their styles");
  app.add_option("--jobs", s.plan.jobs, "cases at a time")->capture_default_str();
  app.add_option("-o,--out", s.out, "JSON file")->capture_default_str();
  app.add_option("--markdown", s.markdown, "page of tables, for instance docs/quality.md");
  app.add_option("--write", s.plan.write_folder, "folder for loops and meshes of the data sets");
  app.add_option("--keep", s.keep, "JSON file of an earlier run: its rows of methods not run now are kept");
  app.add_option("--tables-from", s.tables_from, "run nothing: tables of this JSON file");
  app.add_option("--commit", s.commit, "what to call the code that was measured");
  app.add_option("--date", s.date, "when; today where not given");
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::string part;
  for (std::istringstream in(text); std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

bool is_wanted(const CaseName& name, const std::vector<std::string>& parts) {
  const std::string text = name.text();
  return parts.empty() || std::any_of(parts.begin(), parts.end(), [&](const std::string& part) {
           return text.find(part) != std::string::npos;
         });
}

void make_quick(Settings& s) {
  s.analytic.draws = s.plan.other_draws = 1;
  s.analytic.sizes = {1000};
  s.analytic.noises = {0, 0.5};
  if (s.methods.empty()) s.methods = default_method;
}

bool is_small(const std::string& data, const CaseName& name) {
  constexpr std::uintmax_t quick_bytes = 300'000;
  return fs::file_size(data_path(data, name.shape + ".ply")) <= quick_bytes;
}

// The data sets first: the largest of them takes longest.
std::vector<CaseName> cases_of(const Settings& s) {
  std::vector<CaseName> all;
  if (!s.plan.data.empty()) all = data_cases(s.plan.data);
  if (s.quick) std::erase_if(all, [&](const CaseName& name) { return !is_small(s.plan.data, name); });
  if (!s.no_analytic) {
    for (const auto& more : {topology_cases(s.analytic), analytic_cases(s.analytic)}) {
      all.insert(all.end(), more.begin(), more.end());
    }
  }
  const auto parts = split(s.cases);
  std::erase_if(all, [&](const CaseName& name) {
    return !is_wanted(name, parts) || s.corpus != (name.group == "corpus");
  });
  return all;
}

std::vector<Method> methods_of(const Settings& s) {
  std::vector<Method> all = our_methods();
  all.push_back(arcs_method());
  if (!s.no_peers) {
    for (Method& peer : peer_methods()) all.push_back(std::move(peer));
  }
  const auto wanted = split(s.methods);
  for (const std::string& id : wanted) {
    if (std::none_of(all.begin(), all.end(), [&](const Method& m) { return m.id == id; }))
      throw CLI::ValidationError("--methods", "no method " + id + " here");
  }
  if (!wanted.empty()) {
    std::erase_if(
        all, [&](const Method& m) { return std::find(wanted.begin(), wanted.end(), m.id) == wanted.end(); });
  }
  return all;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

// The folder of the data and where results go tell nothing about the numbers.
std::string command_of(const Settings& s) {
  std::string command = s.corpus ? "bench/quality/corpus" : "bench/quality/run";
  if (s.quick) command += " --quick";
  command += " --seed " + std::to_string(s.analytic.seed) + " --draws " + std::to_string(s.analytic.draws) +
             " --other-draws " + std::to_string(s.plan.other_draws) + " --mesh-draws " +
             std::to_string(s.plan.mesh_draws);
  if (!s.cases.empty()) command += " --cases " + s.cases;
  if (!s.methods.empty()) command += " --methods " + s.methods;
  if (s.no_peers) command += " --no-peers";
  if (s.no_analytic) command += " --no-analytic";
  return command;
}

Results measure(Settings& s) {
  if (s.quick) make_quick(s);
  s.plan.methods = methods_of(s);
  s.plan.cases = cases_of(s);
  if (!s.plan.write_folder.empty()) fs::create_directories(s.plan.write_folder);
  Results results;
  Provenance run{
      command_of(s), rimline::version, s.commit, s.date.empty() ? today() : s.date, s.analytic.seed, {}};
  for (const Method& method : s.plan.methods) {
    run.methods.push_back(method.id);
    results.titles.emplace_back(method.id, method.title);
  }
  results.runs.push_back(std::move(run));
  results.rows = run_plan(s.plan);
  return results;
}

void run(Settings& s) {
  Results results = s.tables_from.empty() ? measure(s) : read_results(s.tables_from);
  if (!s.keep.empty()) keep_other_methods(results, read_results(s.keep));
  if (s.tables_from.empty()) {
    if (const auto folder = fs::path(s.out).parent_path(); !folder.empty()) fs::create_directories(folder);
    write_results(s.out, results);
  }
  const std::string page = s.corpus ? corpus_page(results) : quality_page(results);
  if (s.markdown.empty()) {
    std::fputs(page.c_str(), stdout);
  } else {
    rimline::write_text(s.markdown, page);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{
      "Measures boundary loops and meshes of rimline, its presets and its peers against known truth."};
  Settings settings;
  declare(app, settings);
  CLI11_PARSE(app, argc, argv);
  run(settings);
  return 0;
} catch (const CLI::Error& error) {
  std::fprintf(stderr, "rimline_quality: %s\n", error.what());
  return 1;
} catch (const rimline::Error& error) {
  std::fprintf(stderr, "rimline_quality: %s\n", error.what());
  return rimline::exit_status(error.code());
} catch (const std::exception& error) {
  std::fprintf(stderr, "rimline_quality: %s\n", error.what());
  return 4;
}
