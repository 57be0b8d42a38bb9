// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/runner.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

#include "quality/analytic.h"
#include "quality/data_sets.h"
#include "quality/mesh_score.h"
#include "quality/sound.h"
#include "quality/topology_score.h"
#include "quality/write_outcome.h"

namespace rimline::bench {
namespace {

// The analytic cases that are meshed: 10,000 points, noise that a mesh is expected to bear.
bool is_meshed(const Plan& plan, const CaseName& name) {
  return name.n == 10'000 && (name.noise == 0 || name.noise == 0.2) && name.draw < plan.mesh_draws;
}

bool wants_mesh(const Plan& plan, const Case& c) {
  if (c.name.group == "corpus") return false;  // bench/quality/reliability meshes it
  if (c.name.group == "data") return c.points.size() <= plan.mesh_points;
  if (c.name.group == "topology") return true;
  return is_meshed(plan, c.name);
}

bool takes_part(const Plan& plan, const Method& method, const CaseName& name) {
  if (name.group == "topology") return method.is_default;
  return method.is_default || name.draw < plan.other_draws;
}

// A method that can answer none of the questions asked here is not run.
bool answers(const Method& method, bool want_mesh) {
  return method.finds_boundary || (want_mesh && method.makes_mesh);
}

// A cheap first look, before points are drawn: does anyone answer?
bool anyone_answers(const Plan& plan, const CaseName& name) {
  return std::any_of(plan.methods.begin(), plan.methods.end(), [&](const Method& m) {
    return takes_part(plan, m, name) &&
           (m.finds_boundary || name.group != "analytic" || is_meshed(plan, name));
  });
}

std::optional<Case> make_case(const Plan& plan, const CaseName& name) {
  if (name.is_file()) return read_data_set(plan.data, name);
  auto c = make_analytic(name);
  if (c && name.group == "analytic" && wants_mesh(plan, *c)) c->surface = true_surface(name);
  return c;
}

std::vector<Row> run_case(const Plan& plan, const CaseName& name) {
  std::vector<Row> rows;
  if (!anyone_answers(plan, name)) return rows;
  const std::optional<Case> c = make_case(plan, name);
  if (!c) return rows;
  const bool want_mesh = wants_mesh(plan, *c);
  for (const Method& method : plan.methods) {
    if (!takes_part(plan, method, name) || !answers(method, want_mesh)) continue;
    const bool mesh = want_mesh && method.makes_mesh;
    const Outcome outcome = method.run(*c, mesh);
    rows.push_back(score(*c, method, outcome, mesh));
    if (name.is_file() && !plan.write_folder.empty()) {
      write_outcome(plan.write_folder, *c, method.id, outcome);
    }
  }
  return rows;
}

void report_progress(std::size_t done, std::size_t total, const CaseName& name) {
  std::fprintf(stderr, "\r\033[K%zu of %zu  %s%s", done, total, name.text().c_str(),
               done == total ? "\n" : "");
}

std::vector<Index> probable(const std::vector<float>& probability) {
  std::vector<Index> ids;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    if (probability[i] >= 0.5f) ids.push_back(static_cast<Index>(i));
  }
  return ids;
}

Metrics loops_metrics(const Case& c, const Outcome& outcome) {
  Metrics m = outcome.has_loops ? score_loops(c, outcome.loops) : score_points(c, outcome.boundary);
  if (m.contains("length_over_truth")) m["length_error"] = std::abs(m["length_over_truth"] - 1);
  if (!outcome.probability.empty() && !c.boundary.empty()) {
    m.merge(score_probability(outcome.probability, c.boundary));
    m["probable_points_f1"] = score_points(c, probable(outcome.probability)).at("points_f1");
  }
  if (!outcome.label.empty()) m.merge(score_labels(c, outcome));
  return m;
}

Metrics mesh_metrics(const Case& c, const Outcome& outcome) {
  Metrics m = score_mesh(c, outcome.mesh, outcome.uv);
  if (outcome.has_loops && !outcome.mesh.empty()) m.merge(score_rim(outcome.mesh, outcome.loops));
  if (c.surface) m.merge(score_soundness(c, outcome.mesh, m));
  return m;
}

}  // namespace

Row score(const Case& c, const Method& method, const Outcome& outcome, bool want_mesh) {
  Row row{c.name, method.id, outcome.error, outcome.mesh_error, outcome.seconds, {}, {}, {}};
  if (c.name.group == "topology") {
    row.mesh = score_verdict(c, outcome);
    return row;
  }
  if (method.finds_boundary) row.loops = loops_metrics(c, outcome);
  if (want_mesh) row.mesh = mesh_metrics(c, outcome);
  if (!outcome.probability.empty() && !c.boundary.empty()) {
    row.reliability = measure_reliability(outcome.probability, c.boundary);
  }
  return row;
}

std::vector<Row> run_plan(const Plan& plan) {
  std::vector<std::vector<Row>> found(plan.cases.size());
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < plan.cases.size(); i = next++) {
      try {
        found[i] = run_case(plan, plan.cases[i]);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = plan.cases.size();
      }
      const std::lock_guard lock(mutex);
      ++done;
      if (plan.verbose) report_progress(done, plan.cases.size(), plan.cases[i]);
    }
  };
  std::vector<std::jthread> threads;
  for (int j = 1; j < plan.jobs; ++j) threads.emplace_back(work);
  work();
  threads.clear();
  if (failure) std::rethrow_exception(failure);
  std::vector<Row> rows;
  for (auto& of_case : found) rows.insert(rows.end(), of_case.begin(), of_case.end());
  return rows;
}

}  // namespace rimline::bench
