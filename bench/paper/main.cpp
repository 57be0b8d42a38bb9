// SPDX-License-Identifier: GPL-3.0-or-later
// rimline_bench_paper: the experiments of the paper on one set, as JSON. bench/README.md
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "paper/search.h"
#include "paper/theory.h"
#include "paper/undersampling.h"

namespace {

using namespace rimline;
using namespace rimline::bench;
using Json = nlohmann::ordered_json;

constexpr int most_k = 60;  // of all variants

struct Settings {
  std::string set, truth;
  int path_k = 40, seeds = 10, variant_seeds = 3;
  bool variants = false, windows = false;
};

// A change of one thing.
struct Variant {
  std::string name;
  BoundaryOptions boundary;
  LoopOptions loops;
  bool turned = false;
};

LoopOptions paper_options(const Settings& s) {
  LoopOptions options = preset_options(Preset::Paper).loops;
  options.path_k = s.path_k;
  return options;
}

std::vector<Variant> variants_of(const Settings& s) {
  const LoopOptions paper = paper_options(s);
  std::vector<Variant> all = {{"as it is", {}, paper}};
  const auto with_loops = [&](const std::string& name, auto change) {
    all.push_back({name, {}, paper});
    change(all.back().loops);
  };
  const auto with_test = [&](const std::string& name, int k, int r, double alpha) {
    all.push_back({name, {.k = k, .sectors = r, .significance = alpha}, paper});
  };
  with_loops("K = 0", [](LoopOptions& o) { o.generations = 0; });
  with_loops("no mutation", [](LoopOptions& o) { o.mutation_probability = 0; });
  all.push_back({"start angle turned by pi/8", {}, paper, true});
  with_loops("exponent 0.8", [](LoopOptions& o) { o.length_exponent = 0.8; });
  with_loops("exponent 1", [](LoopOptions& o) { o.length_exponent = 1; });
  with_test("alpha = 0.05", 40, 8, 0.05);
  with_test("alpha = 0.20", 40, 8, 0.20);
  with_test("k = 20, r = 4", 20, 4, 0.10);
  with_test("k = 60, r = 12", 60, 12, 0.10);
  with_test("r = 6", 40, 6, 0.10);
  with_test("r = 10", 40, 10, 0.10);
  return all;
}

Json runs(const PointSet& set, const Paths& paths, const LoopOptions& options, int seeds) {
  Json list = Json::array();
  for (int seed = 1; seed <= seeds; ++seed) {
    try {
      list.push_back(measure_run(set, paths, options, static_cast<std::uint64_t>(seed)));
    } catch (const Error& error) {
      list.push_back({{"seed", seed}, {"error", error.what()}});
    }
  }
  return list;
}

Json measure_variants(const PointSet& set, const Paths& paths, const Settings& s) {
  Json json;
  for (const Variant& v : variants_of(s)) {
    BoundaryScores scores = v.turned ? turned_scores(set, v.boundary)
                                     : score_boundary(set.points, set.neighbours, v.boundary, {});
    std::size_t flags = 0;
    for (std::size_t i = 0; i < scores.candidate.size(); ++i)
      flags += scores.candidate[i] != paths.scores.candidate[i];
    const Paths changed = flags == 0 ? paths : find_paths(set, std::move(scores), v.loops);
    json[v.name] = {{"flags", flags}, {"runs", runs(set, changed, v.loops, s.variant_seeds)}};
  }
  return json;
}

Json measure(const Settings& s) {
  const PointSet set = read_point_set(s.set, s.truth, most_k);
  const LoopOptions paper = paper_options(s);
  const Paths paths = find_paths(set, score_boundary(set.points, set.neighbours, {}, {}), paper);
  Json json{{"points", set.points.size()}, {"path_k", s.path_k}};
  json["theory"] = measure_theory(set, paths.scores, {});
  json["undersampling"] = measure_undersampling(set, paths.scores);
  json["plateau"] = measure_plateau(set, paths, paper);
  for (const ScoreForm form : {ScoreForm::Capped, ScoreForm::Printed, ScoreForm::Log}) {
    LoopOptions options = paper;
    options.score_form = form;
    LoopOptions unbred = options;
    unbred.generations = 0;
    json["forms"][name(form)] = {
        {"paths", measure_best_paths(set, paths, options)},
        {"K0", runs(set, paths, unbred, 1)},
        {"runs", runs(set, paths, options, form == ScoreForm::Capped ? s.seeds : 3)}};
  }
  if (s.variants) json["variants"] = measure_variants(set, paths, s);
  if (s.windows) json["windows"] = measure_windows(s.set, s.truth);
  return json;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Runs the experiments of the paper on one set and prints them as JSON."};
  Settings s;
  app.add_option("set", s.set, "points; a property `boundary` is truth")->required();
  app.add_option("--truth", s.truth, "the mesh that the points come from, with the same vertices");
  app.add_option("--path-k", s.path_k, "neighbours in Algorithm 3.1")->capture_default_str();
  app.add_option("--seeds", s.seeds, "runs of Algorithm 3.2")->capture_default_str();
  app.add_flag("--variants", s.variants, "changes of one thing at a time as well");
  app.add_flag("--windows", s.windows, "the mesh as well, and which true holes it fills");
  CLI11_PARSE(app, argc, argv);
  std::fputs((measure(s).dump(1) + "\n").c_str(), stdout);
  return 0;
} catch (const rimline::Error& error) {
  fmt::print(stderr, "rimline_bench_paper: {}\n", error.what());
  return rimline::exit_status(error.code());
}
