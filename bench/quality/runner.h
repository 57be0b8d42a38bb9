// SPDX-License-Identifier: GPL-3.0-or-later
// Asks every method every question.
#pragma once

#include <string>
#include <vector>

#include "quality/method.h"
#include "quality/results.h"

namespace rimline::bench {

struct Plan {
  std::vector<CaseName> cases;
  std::vector<Method> methods;
  std::string data;                   // the data folder
  int other_draws = 3;                // methods other than the default run on the first few draws of a case
  int mesh_draws = 1;                 // ... and meshes are made of as many
  std::size_t mesh_points = 200'000;  // and of data sets up to this size
  int jobs = 2;                       // cases at a time
  std::string write_folder;           // where not empty: loops and meshes of the data sets are left here
  bool verbose = true;                // one line a case on standard error
};

// Rows in the order of the cases, then of the methods, whatever the number of jobs.
std::vector<Row> run_plan(const Plan& plan);

// Scores one outcome; what run_plan does for each.
Row score(const Case& c, const Method& method, const Outcome& outcome, bool want_mesh);

}  // namespace rimline::bench
