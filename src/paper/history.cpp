// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/history.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace rimline {

void SearchHistory::add(BestChromosome best) {
  if (best.generation % stride_ != 0) return;
  points_ += best.points.size();
  generations_.push_back(std::move(best));
  while (points_ > most_points && generations_.size() > 1) {
    stride_ *= 2;
    std::erase_if(generations_, [this](const BestChromosome& b) { return b.generation % stride_ != 0; });
    points_ = 0;
    for (const BestChromosome& b : generations_) points_ += b.points.size();
  }
}

void SearchHistory::rename(const std::vector<Index>& ids) {
  for (BestChromosome& best : generations_) {
    for (Index& point : best.points) point = ids[point];
    std::sort(best.points.begin(), best.points.end());
  }
}

std::string history_to_json(const SearchHistory& history, std::size_t point_count) {
  using Json = nlohmann::ordered_json;
  std::string text = Json{{"schema", 1}, {"points", point_count}, {"stride", history.stride()}}.dump();
  text.back() = ',';
  text += "\n \"generations\": [";
  const char* between = "\n  ";
  for (const BestChromosome& best : history.generations()) {
    text += between +
            Json{{"generation", best.generation}, {"fitness", best.fitness}, {"points", best.points}}.dump();
    between = ",\n  ";
  }
  return text + "\n ]}\n";
}

}  // namespace rimline
