// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace rimline::cli {
namespace {

constexpr std::size_t most_charts = 40;

// Selects the charts that are drawn.
std::vector<char> chosen_charts(std::span<const Index> chart) {
  std::vector<std::size_t> size;
  for (const Index c : chart) {
    if (c == none) continue;
    if (static_cast<std::size_t>(c) >= size.size()) size.resize(c + 1, 0);
    ++size[c];
  }
  std::vector<Index> order(size.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, [&](Index a, Index b) { return size[a] > size[b]; });
  std::vector<char> chosen(size.size(), 0);
  for (std::size_t i = 0; i < std::min(most_charts, order.size()); ++i) chosen[order[i]] = 1;
  return chosen;
}

using Side = std::pair<Index, Index>;

// Edges of one triangle, in its direction.
template <class Corners>
std::vector<Side> open_sides(const Corners& triangles) {
  std::vector<Side> sides;
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) sides.emplace_back(t[c], t[(c + 1) % 3]);
  }
  std::vector<Side> sorted = sides;
  for (auto& [a, b] : sorted) {
    if (a > b) std::swap(a, b);
  }
  std::ranges::sort(sorted);
  std::erase_if(sides, [&](Side side) {
    if (side.first > side.second) std::swap(side.first, side.second);
    const auto [low, high] = std::ranges::equal_range(sorted, side);
    return high - low != 1;
  });
  return sides;
}

}  // namespace

DrawnMap drawn_map(const Scene& scene) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<char> chosen = chosen_charts(scene.chart);
  DrawnMap map;
  map.uv.assign(scene.uv.begin(), scene.uv.end());
  map.uv.insert(map.uv.end(), scene.seams.uv.begin(), scene.seams.uv.end());
  map.charts = static_cast<std::size_t>(std::ranges::count(chosen, 1));
  map.left_out = chosen.size() - map.charts;
  std::vector<char> drawn(map.uv.size(), map.left_out == 0);
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const Triangle& corners = scene.seams.empty() ? scene.triangles[t] : scene.seams.corners[t];
    const bool has_chart = !scene.chart.empty();
    if (has_chart && (scene.chart[t] == none || !chosen[scene.chart[t]])) continue;
    map.triangles.push_back(scene.triangles[t]);
    map.corners.push_back(corners);
    for (const Index place : corners) drawn[place] = 1;
  }
  for (std::size_t place = 0; place < map.uv.size(); ++place) {
    if (!drawn[place]) map.uv[place] = {nan, nan};
  }
  return map;
}

std::string tell_charts(const DrawnMap& map) {
  if (map.left_out > 0)
    return fmt::format("the largest {} of {} charts", map.charts, map.charts + map.left_out);
  return map.charts > 1 ? fmt::format("{} charts", map.charts) : "";
}

Outline outline_of(const DrawnMap& map) {
  const std::vector<Side> boundary = [&] {
    std::vector<Side> sides = open_sides(map.triangles);
    for (auto& [a, b] : sides) {
      if (a > b) std::swap(a, b);
    }
    std::ranges::sort(sides);
    return sides;
  }();
  Outline outline;
  std::vector<Index> point(map.uv.size(), none);
  for (std::size_t t = 0; t < map.corners.size(); ++t) {
    for (int c = 0; c < 3; ++c) point[map.corners[t][c]] = map.triangles[t][c];
  }
  for (const Side& side : open_sides(map.corners)) {
    const Side of_points = std::minmax(point[side.first], point[side.second]);
    (std::ranges::binary_search(boundary, of_points) ? outline.boundary : outline.seams).push_back(side);
  }
  return outline;
}

}  // namespace rimline::cli
