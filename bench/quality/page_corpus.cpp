// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of a corpus by style.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "quality/pages.h"
#include "quality/table.h"

namespace rimline::bench {
namespace {

Rows rows_of(const Results& results, const std::string& method, const std::string& style) {
  return choose(results.rows, [&](const Row& row) {
    return row.method == method && row.name.group == "corpus" &&
           (style.empty() || row.name.sampling == style);
  });
}

// Ascending, then "" for all of them.
std::vector<std::string> styles_of(const Results& results) {
  std::set<std::string> styles;
  for (const Row& row : results.rows) {
    if (row.name.group == "corpus") styles.insert(row.name.sampling);
  }
  std::vector<std::string> all(styles.begin(), styles.end());
  all.emplace_back();
  return all;
}

double sum_of(const Rows& rows, const std::string& metric) {
  double sum = 0;
  for (const Row* row : rows) {
    const auto found = row->loops.find(metric);
    if (found != row->loops.end()) sum += found->second;
  }
  return sum;
}

std::string by_style(const Results& results) {
  Table table({"style", "sets", "points F1", "within one spacing", "edges F1", "loop count right",
               "all exact", "loops", "missed", "false"});
  for (const std::string& style : styles_of(results)) {
    const Rows rows = rows_of(results, default_method, style);
    table.add({style.empty() ? "all" : style, std::to_string(rows.size()),
               mean_of(rows, &Row::loops, "points_f1"),
               mean_of(rows, &Row::loops, "points_f1_within_one_spacing"),
               mean_of(rows, &Row::loops, "edges_f1"), mean_of(rows, &Row::loops, "loops_right", 2),
               mean_of(rows, &Row::loops, "all_exact", 2), number(sum_of(rows, "loops_true"), 0),
               number(sum_of(rows, "loops_missed"), 0), number(sum_of(rows, "loops_false"), 0)});
  }
  return table.markdown();
}

std::string by_method(const Results& results, const std::string& metric) {
  std::vector<std::string> header{"style"};
  for (const auto& [id, title] : results.titles) {
    if (sum_of(rows_of(results, id, ""), metric) > 0) header.push_back(title);
  }
  Table table(header);
  for (const std::string& style : styles_of(results)) {
    std::vector<std::string> cells{style.empty() ? "all" : style};
    for (const auto& [id, title] : results.titles) {
      if (sum_of(rows_of(results, id, ""), metric) == 0) continue;
      cells.push_back(mean_of(rows_of(results, id, style), &Row::loops, metric));
    }
    table.add(std::move(cells));
  }
  return table.markdown();
}

std::string worst_sets(const Results& results) {
  constexpr std::size_t most = 10;
  Rows rows = rows_of(results, default_method, "");
  const auto f1 = [](const Row* row) {
    const auto found = row->loops.find("points_f1");
    return found == row->loops.end() ? 0 : found->second;
  };
  std::ranges::stable_sort(rows, {}, f1);
  rows.resize(std::min(rows.size(), most));
  Table table({"set", "style", "points", "points F1", "within one spacing", "loops found / true"});
  for (const Row* row : rows) {
    const auto value = [&](const char* metric, int digits) {
      const auto found = row->loops.find(metric);
      return found == row->loops.end() ? std::string("-") : number(found->second, digits);
    };
    table.add({row->name.shape, row->name.sampling, std::to_string(row->name.n), value("points_f1", 3),
               value("points_f1_within_one_spacing", 3),
               value("loops_found", 0) + " / " + value("loops_true", 0)});
  }
  return table.markdown();
}

}  // namespace

std::string corpus_page(const Results& results) {
  return "# Loops over a corpus\n\n"
         "Written by `bench/quality/corpus`, which needs a folder of point sets with known loops and an "
         "index of "
         "their styles\nin `RIMLINE_DATA`. Every number is the mean over the sets of a style; what each "
         "means is in "
         "[bench/README.md](../bench/README.md).\n\n" +
         provenance_section(results) + "\n## The default method\n\n" + by_style(results) +
         "\n## Points F1 by method\n\n" + by_method(results, "points_f1") + "\n## Edges F1 by method\n\n" +
         by_method(results, "edges_f1") + "\n## The worst ten sets\n\n" + worst_sets(results);
}

}  // namespace rimline::bench
