// SPDX-License-Identifier: GPL-3.0-or-later
// All that was measured, and the file it is kept in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "quality/case.h"
#include "quality/metrics.h"
#include "quality/reliability.h"

namespace rimline::bench {

// One method on one case.
struct Row {
  CaseName name;
  std::string method;      // Method::id
  std::string error;       // why there was no boundary
  std::string mesh_error;  // why there was no mesh though one was wanted
  double seconds = 0;      // of one thread, on a machine that may be shared
  Metrics loops, mesh;     // either may be empty: not asked
  std::optional<Reliability> reliability;
};

// How rows came to be. Rows of several runs may stand in one file (--keep).
struct Provenance {
  std::string command, version, commit, date;
  std::uint64_t seed = 1;
  std::vector<std::string> methods;
};

struct Results {
  std::vector<Provenance> runs;
  std::vector<std::pair<std::string, std::string>>
      titles;  // Method::id and title, in the order of the tables
  std::vector<Row> rows;
};

void write_results(const std::string& path, const Results& results);
Results read_results(const std::string& path);

// Adds from `old` the rows, titles and runs of methods that `results` does not have.
void keep_other_methods(Results& results, const Results& old);

}  // namespace rimline::bench
