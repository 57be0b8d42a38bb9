// SPDX-License-Identifier: GPL-3.0-or-later
// Rows chosen, summed up, and set as a markdown table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "quality/results.h"

namespace rimline::bench {

using Rows = std::vector<const Row*>;
using Choice = std::function<bool(const Row&)>;

Rows choose(const std::vector<Row>& rows, const Choice& choice);
Rows choose(const Rows& rows, const Choice& choice);

// Mean, least and most of a metric over the rows that have it.
struct Summary {
  std::size_t count = 0;
  double mean = 0, least = 0, most = 0;
};
Summary summarize(const Rows& rows, Metrics Row::*part, const std::string& metric);

// "0.987", "-" where there is nothing. With the worst: "0.987 (0.91)".
std::string number(double value, int digits = 3);
std::string mean_of(const Rows& rows, Metrics Row::*part, const std::string& metric, int digits = 3);
std::string mean_and_least(const Rows& rows, Metrics Row::*part, const std::string& metric, int digits = 3);
std::string mean_and_most(const Rows& rows, Metrics Row::*part, const std::string& metric, int digits = 3);
// Of a metric that is 0 or 1: "98 %".
std::string percent_of(const Rows& rows, Metrics Row::*part, const std::string& metric);

class Table {
 public:
  explicit Table(std::vector<std::string> header) : header_(std::move(header)) {}
  void add(std::vector<std::string> cells) { cells_.push_back(std::move(cells)); }
  bool empty() const { return cells_.empty(); }
  // Columns as wide as their widest cell.
  std::string markdown() const;

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> cells_;
};

}  // namespace rimline::bench
