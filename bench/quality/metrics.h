// SPDX-License-Identifier: GPL-3.0-or-later
// What one method scored on one case: numbers by name, as they stand in the JSON file. bench/README.md
#pragma once

#include <map>
#include <string>

namespace rimline::bench {

using Metrics = std::map<std::string, double>;

// Precision, recall and F1 from counts. Nothing found and nothing true is right.
struct F1 {
  double precision = 0, recall = 0, f1 = 0;
};
F1 f1_of(std::size_t common, std::size_t found, std::size_t truth);
F1 f1_of_shares(double precision, double recall);

}  // namespace rimline::bench
