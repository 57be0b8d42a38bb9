// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "quality/pages.h"
#include "quality/table.h"

namespace rimline::bench {
namespace {

Reliability pooled(const Rows& rows) {
  Reliability sum;
  for (const Row* row : rows) sum.add(*row->reliability);
  return sum;
}

void add_bins(const Reliability& analytic, const Reliability& data, Table& table) {
  const auto share = [](const Reliability::Bin& bin) {
    return bin.points == 0 ? std::string("-") : fmt::format("{:.4f}", bin.boundary / bin.points);
  };
  for (std::size_t i = 0; i < analytic.bins.size(); ++i) {
    const auto &a = analytic.bins[i], &d = data.bins[i];
    table.add({fmt::format("{:.1f} to {:.1f}", 0.1 * i, 0.1 * (i + 1)), fmt::format("{:.0f}", a.points),
               share(a), fmt::format("{:.0f}", d.points), share(d)});
  }
  table.add({"Brier score", number(analytic.brier(), 5), "", number(data.brier(), 5), ""});
  table.add({"of the best constant", number(analytic.constant_brier(), 5), "",
             number(data.constant_brier(), 5), ""});
  table.add({"better by", fmt::format("{:.1f} %", 100 * analytic.gain()), "",
             fmt::format("{:.1f} %", 100 * data.gain()), ""});
}

std::string sets_table(const Rows& rows) {
  Table table({"set", "boundary points with 0.5 or more", "with less than 0.1", "Brier better by"});
  for (const Row* row : rows) {
    const Rows one{row};
    table.add({row->name.shape, percent_of(one, &Row::loops, "boundary_probability_half"),
               mean_of(one, &Row::loops, "boundary_probability_low"),
               fmt::format("{:.1f} %", 100 * row->reliability->gain())});
  }
  return table.markdown();
}

}  // namespace

std::string reliability_section(const Results& results) {
  const Rows rows = choose(results.rows, [](const Row& row) {
    return row.method == default_method && row.reliability.has_value();
  });
  if (rows.empty()) return "";
  const Rows analytic = choose(rows, [](const Row& row) { return row.name.group == "analytic"; });
  const Rows data = choose(rows, [](const Row& row) { return row.name.group == "data"; });
  Table table({"boundary_probability", "analytic: points", "true boundary", "data: points", "true boundary"});
  add_bins(pooled(analytic), pooled(data), table);
  return "\n## Reliability\n\nOf the points given a probability, the share that is on the true "
         "boundary:\n\n" +
         table.markdown() + "\n" + sets_table(data);
}

}  // namespace rimline::bench
