// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "quality/pages.h"
#include "quality/table.h"

namespace rimline::bench {

std::string provenance_section(const Results& results) {
  Table table({"methods", "command", "seed", "version", "commit", "date"});
  for (const Provenance& run : results.runs) {
    table.add({fmt::format("{}", fmt::join(run.methods, ", ")), "`" + run.command + "`",
               std::to_string(run.seed), run.version, run.commit, run.date});
  }
  return table.markdown();
}

std::string quality_page(const Results& results) {
  return "# Quality\n\n"
         "Written by `bench/quality/run`; what each number means is in "
         "[bench/README.md](../bench/README.md). "
         "Where two numbers\nstand as `mean (worst)`, both are over all shapes and seeds of the line. A "
         "method "
         "that fails scores 0.\n\n" +
         provenance_section(results) + aims_section(results) + analytic_loops_section(results) +
         data_loops_section(results) + reliability_section(results) + search_section(results) +
         mesh_section(results);
}

}  // namespace rimline::bench
