// SPDX-License-Identifier: GPL-3.0-or-later
// What each step of the default adds: arcs of local evidence alone, their join without the search, the
// search.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "quality/pages.h"
#include "quality/table.h"

namespace rimline::bench {
namespace {

constexpr const char* arcs = "arcs";
constexpr const char* greedy = "greedy";

// The rows of the three methods on one case.
struct Steps {
  const Row* arcs = nullptr;
  const Row* greedy = nullptr;
  const Row* search = nullptr;
};

double get(const Row& row, const char* metric) {
  const auto found = row.loops.find(metric);
  return found == row.loops.end() ? 0 : found->second;
}

// All loops and no other, on the boundary within a spacing, as long as the truth.
bool is_right(const Row& row) {
  const double length = row.name.noise > 0 || row.name.shape.find("noisy") != std::string::npos ? 0.10 : 0.05;
  return get(row, "loops_right") == 1 && get(row, "points_f1_within_one_spacing") >= 0.99 &&
         get(row, "length_error") <= length && get(row, "simple") == 1 && get(row, "crossings") == 0;
}

// Cases in the order of the results.
std::vector<Steps> steps_of(const Results& results) {
  std::vector<Steps> cases;
  std::map<std::string, std::size_t> place;
  for (const Row& row : results.rows) {
    if (!row.loops.contains("edges_f1") || row.name.group == "corpus") continue;
    if (row.method != arcs && row.method != greedy && row.method != default_method) continue;
    const auto [found, is_new] = place.try_emplace(row.name.text(), cases.size());
    if (is_new) cases.emplace_back();
    Steps& steps = cases[found->second];
    (row.method == arcs ? steps.arcs : row.method == greedy ? steps.greedy : steps.search) = &row;
  }
  std::erase_if(cases, [](const Steps& s) { return !s.arcs || !s.greedy || !s.search; });
  return cases;
}

std::string line_of(const CaseName& name) {
  if (name.group == "data") return name.shape;
  return fmt::format("{}, noise {}, n {}", name.sampling, name.noise, name.n);
}

std::string cell(const std::vector<Steps>& cases, const Row* Steps::*which) {
  double edges = 0, right = 0;
  for (const Steps& steps : cases) {
    edges += get(*(steps.*which), "edges_f1");
    right += is_right(*(steps.*which));
  }
  const auto n = static_cast<double>(cases.size());
  return fmt::format("{:.3f}, right {:.0f} of {:.0f}", edges / n, right, n);
}

std::string names_of(const std::vector<Steps>& cases, const Row* Steps::*right, const Row* Steps::*wrong) {
  constexpr std::size_t most = 12;
  std::string names;
  std::size_t count = 0;
  for (const Steps& steps : cases) {
    if (!is_right(*(steps.*right)) || is_right(*(steps.*wrong))) continue;
    if (++count <= most) names += std::string(count == 1 ? "" : ", ") + (steps.*right)->name.text();
  }
  if (count > most) names += fmt::format(" and {} more", count - most);
  return count == 0 ? std::string("none") : fmt::format("{}: {}", count, names);
}

}  // namespace

std::string search_section(const Results& results) {
  const std::vector<Steps> cases = steps_of(results);
  if (cases.empty()) return "";
  std::vector<std::pair<std::string, std::vector<Steps>>> lines;
  for (const Steps& steps : cases) {
    const std::string line = line_of(steps.search->name);
    auto found = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.first == line; });
    if (found == lines.end()) found = lines.insert(lines.end(), {line, {}});
    found->second.push_back(steps);
  }
  Table table({"cases", "arcs alone", "greedy join", "search"});
  for (const auto& [line, of_line] : lines) {
    table.add(
        {line, cell(of_line, &Steps::arcs), cell(of_line, &Steps::greedy), cell(of_line, &Steps::search)});
  }
  return fmt::format(
      "\n## What the search adds\n\nEdges F1, and the cases that are right: as many loops as are true, 0.99 "
      "within "
      "a spacing, length within\n5 % (10 % under noise), simple, not crossing.\n\n{}\n"
      "- the search is right and the greedy join wrong: {}\n- the greedy join is right and the search wrong: "
      "{}\n",
      table.markdown(), names_of(cases, &Steps::search, &Steps::greedy),
      names_of(cases, &Steps::greedy, &Steps::search));
}

}  // namespace rimline::bench
