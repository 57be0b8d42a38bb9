// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "quality/pages.h"
#include "quality/table.h"

namespace rimline::bench {
namespace {

const std::vector<std::string>& stages() {
  static const std::vector<std::string> ids{"arcs", "greedy", default_method};
  return ids;
}

bool was_run(const Results& results, const std::string& id) {
  return std::any_of(results.titles.begin(), results.titles.end(),
                     [&](const auto& title) { return title.first == id; });
}

// What the lines of the table are: each data set, and each analytic sampling with its noise and size.
std::string line_of(const CaseName& name) {
  if (name.group == "data") return name.shape;
  return name.shape + ", " + name.sampling + ", noise " + number(name.noise, 1) + ", n " +
         std::to_string(name.n);
}

std::string loops_cell(const Rows& rows) {
  if (rows.empty()) return "-";
  return mean_of(rows, &Row::loops, "edges_f1") + ", " + mean_of(rows, &Row::loops, "loops_exact", 2) +
         " of " + mean_of(rows, &Row::loops, "loops_true", 0);
}

}  // namespace

std::string search_section(const Results& results) {
  if (!was_run(results, "arcs") && !was_run(results, "greedy")) return "";
  Table table({"case", "arcs alone", "greedy join", "search"});
  std::set<std::string> lines;
  for (const Row& row : results.rows) {
    if (row.method == "greedy" && row.loops.contains("edges_f1")) lines.insert(line_of(row.name));
  }
  for (const std::string& line : lines) {
    std::vector<std::string> cells{line};
    for (const std::string& id : stages()) {
      cells.push_back(loops_cell(choose(results.rows, [&](const Row& row) {
        return row.method == id && row.loops.contains("edges_f1") && line_of(row.name) == line;
      })));
    }
    if (cells[1] != cells[3] || cells[2] != cells[3]) table.add(std::move(cells));
  }
  return "\n## What the search adds\n\nEdges F1, and loops exact of true ones, on the cases where the three "
         "differ:\n\n" +
         table.markdown();
}

}  // namespace rimline::bench
