// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace rimline::bench {
namespace {

// Code points, since titles have a degree sign.
std::size_t width_of(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; });
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += " " + cells[i] + std::string(widths[i] - width_of(cells[i]), ' ') + " |";
  }
  return text + "\n";
}

}  // namespace

Rows choose(const std::vector<Row>& rows, const Choice& choice) {
  Rows chosen;
  for (const Row& row : rows) {
    if (choice(row)) chosen.push_back(&row);
  }
  return chosen;
}

Rows choose(const Rows& rows, const Choice& choice) {
  Rows chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen),
               [&](const Row* row) { return choice(*row); });
  return chosen;
}

Summary summarize(const Rows& rows, Metrics Row::*part, const std::string& metric) {
  Summary s;
  for (const Row* row : rows) {
    const auto found = (row->*part).find(metric);
    if (found == (row->*part).end()) continue;
    const double value = found->second;
    s.least = s.count == 0 ? value : std::min(s.least, value);
    s.most = s.count == 0 ? value : std::max(s.most, value);
    s.mean += value;
    ++s.count;
  }
  if (s.count > 0) s.mean /= static_cast<double>(s.count);
  return s;
}

std::string number(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }

std::string mean_of(const Rows& rows, Metrics Row::*part, const std::string& metric, int digits) {
  const Summary s = summarize(rows, part, metric);
  return s.count == 0 ? "-" : number(s.mean, digits);
}

std::string mean_and_least(const Rows& rows, Metrics Row::*part, const std::string& metric, int digits) {
  const Summary s = summarize(rows, part, metric);
  return s.count == 0 ? "-" : fmt::format("{} ({})", number(s.mean, digits), number(s.least, digits - 1));
}

std::string mean_and_most(const Rows& rows, Metrics Row::*part, const std::string& metric, int digits) {
  const Summary s = summarize(rows, part, metric);
  return s.count == 0 ? "-" : fmt::format("{} ({})", number(s.mean, digits), number(s.most, digits - 1));
}

std::string percent_of(const Rows& rows, Metrics Row::*part, const std::string& metric) {
  const Summary s = summarize(rows, part, metric);
  return s.count == 0 ? "-" : fmt::format("{:.0f} %", 100 * s.mean);
}

std::string Table::markdown() const {
  std::vector<std::size_t> widths;
  for (const auto& cell : header_) widths.push_back(width_of(cell));
  for (const auto& row : cells_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::vector<std::string> rule;
  for (const std::size_t width : widths) rule.push_back(std::string(width, '-'));
  std::string text = line(header_, widths) + line(rule, widths);
  for (const auto& row : cells_) text += line(row, widths);
  return text;
}

}  // namespace rimline::bench
