// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <set>

#include "quality/pages.h"
#include "quality/table.h"
#include "rimline/sample.h"

namespace rimline::bench {
namespace {

struct Line {
  std::string sampling;
  double noise;
  std::size_t n;
};

std::vector<Line> lines_of(const Results& results) {
  std::vector<Line> lines;
  for (const std::size_t n : {10'000, 1'000}) {
    for (const Sampling sampling : all_samplings()) {
      std::set<double> noises;
      for (const Row& row : results.rows) {
        if (row.name.group == "analytic" && row.name.n == n && row.name.sampling == name(sampling))
          noises.insert(row.name.noise);
      }
      for (const double noise : noises) lines.push_back({name(sampling), noise, n});
    }
  }
  return lines;
}

Rows rows_of(const Results& results, const Line& line, const std::string& method) {
  return choose(results.rows, [&](const Row& row) {
    return row.method == method && row.name.group == "analytic" && row.name.sampling == line.sampling &&
           row.name.noise == line.noise && row.name.n == line.n && !row.loops.empty();
  });
}

std::vector<std::pair<std::string, std::string>> boundary_methods(const Results& results) {
  std::vector<std::pair<std::string, std::string>> methods;
  for (const auto& title : results.titles) {
    const Rows rows =
        choose(results.rows, [&](const Row& r) { return r.method == title.first && !r.loops.empty(); });
    if (!rows.empty()) methods.push_back(title);
  }
  return methods;
}

std::string default_table(const Results& results, const std::vector<Line>& lines) {
  Table table({"sampling", "n", "noise", "runs", "points F1", "within a spacing", "edges F1",
               "loop count right", "all loops exact", "length error", "simple", "no crossing"});
  for (const Line& line : lines) {
    const Rows rows = rows_of(results, line, default_method);
    if (rows.empty()) continue;
    const Rows crossing = choose(rows, [](const Row& r) {
      const auto found = r.loops.find("crossings");
      return found != r.loops.end() && found->second > 0;
    });
    const auto clean = static_cast<double>(rows.size() - crossing.size()) / static_cast<double>(rows.size());
    table.add({line.sampling, std::to_string(line.n), fmt::format("{}", line.noise),
               std::to_string(rows.size()), mean_and_least(rows, &Row::loops, "points_f1"),
               mean_and_least(rows, &Row::loops, "points_f1_within_one_spacing"),
               mean_and_least(rows, &Row::loops, "edges_f1"), percent_of(rows, &Row::loops, "loops_right"),
               percent_of(rows, &Row::loops, "all_exact"), mean_and_most(rows, &Row::loops, "length_error"),
               percent_of(rows, &Row::loops, "simple"), fmt::format("{:.0f} %", 100 * clean)});
  }
  return table.markdown();
}

std::string comparison(const Results& results, const std::vector<Line>& lines, const std::string& metric) {
  std::vector<std::string> header{"sampling", "n", "noise"};
  const auto methods = boundary_methods(results);
  for (const auto& [id, title] : methods) header.push_back(title);
  Table table(header);
  for (const Line& line : lines) {
    std::vector<std::string> cells{line.sampling, std::to_string(line.n), fmt::format("{}", line.noise)};
    for (const auto& [id, title] : methods) {
      cells.push_back(mean_and_least(rows_of(results, line, id), &Row::loops, metric));
    }
    table.add(std::move(cells));
  }
  return table.markdown();
}

std::string default_sets(const Results& results) {
  Table table({"set", "points", "points F1", "within a spacing", "edges F1", "loops found / true", "exact",
               "four longest, within a spacing", "length / truth", "simple", "crossings, of the truth"});
  for (const Row& row : results.rows) {
    if (row.method != default_method || row.name.group != "data") continue;
    const auto value = [&](const char* metric, int digits = 3) {
      const auto found = row.loops.find(metric);
      return found == row.loops.end() ? std::string("-") : number(found->second, digits);
    };
    std::string longest;
    for (const char* which :
         {"longest_within_1", "longest_within_2", "longest_within_3", "longest_within_4"}) {
      if (row.loops.contains(which)) longest += (longest.empty() ? "" : ", ") + value(which, 2);
    }
    table.add({row.name.shape, std::to_string(row.name.n), value("points_f1"),
               value("points_f1_within_one_spacing"), value("edges_f1"),
               value("loops_found", 0) + " / " + value("loops_true", 0), value("loops_exact", 0),
               longest.empty() ? "-" : longest, value("length_over_truth"), value("simple", 0),
               value("crossings", 0) + ", " + value("crossings_of_truth", 0)});
  }
  return table.markdown();
}

std::vector<std::string> sets_of(const Results& results) {
  std::set<std::string> sets;
  for (const Row& row : results.rows) {
    if (row.name.group == "data" && row.loops.contains("points_f1")) sets.insert(row.name.shape);
  }
  return {sets.begin(), sets.end()};
}

std::string compared_sets(const Results& results, const std::string& metric) {
  std::vector<std::string> header{"set"};
  const auto methods = boundary_methods(results);
  for (const auto& [id, title] : methods) header.push_back(title);
  Table table(header);
  std::vector<std::string> sets = sets_of(results);
  sets.push_back("");  // the mean
  for (const std::string& set : sets) {
    std::vector<std::string> cells{set.empty() ? "mean" : set};
    for (const auto& [id, title] : methods) {
      const Rows rows = choose(results.rows, [&, wanted = id](const Row& r) {
        return r.method == wanted && r.name.group == "data" && (set.empty() || r.name.shape == set);
      });
      cells.push_back(mean_of(rows, &Row::loops, metric));
    }
    table.add(std::move(cells));
  }
  return table.markdown();
}

}  // namespace

std::string analytic_loops_section(const Results& results) {
  const auto lines = lines_of(results);
  if (lines.empty()) return "";
  return "\n## Loops on analytic shapes\n\nThe default:\n\n" + default_table(results, lines) +
         "\nPoints F1 of all methods, those other than the default on the first seeds alone:\n\n" +
         comparison(results, lines, "points_f1") +
         "\nThe same against the points of the loops alone (else, of random "
         "sampling the points within half a spacing of the\nboundary curve are true as well):\n\n" +
         comparison(results, lines, "rim_points_f1") + "\nPoints F1 within one spacing:\n\n" +
         comparison(results, lines, "points_f1_within_one_spacing");
}

std::string data_loops_section(const Results& results) {
  if (sets_of(results).empty()) return "";
  return "\n## Loops on the data sets\n\nThe default:\n\n" + default_sets(results) +
         "\nPoints F1 of all methods:\n\n" + compared_sets(results, "points_f1") +
         "\nPoints F1 within one spacing:\n\n" + compared_sets(results, "points_f1_within_one_spacing");
}

}  // namespace rimline::bench
