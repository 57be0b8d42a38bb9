// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/pack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rimline {
namespace {

struct UVBox {
  std::size_t vertices = 0;
  UV low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  UV high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void include(UV p) {
    ++vertices;
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  bool empty() const { return !(low.u <= high.u); }
  double width() const { return high.u - low.u; }
  double height() const { return high.v - low.v; }
};

std::vector<UVBox> boxes_of(std::span<const Index> patch, std::size_t count, const std::vector<UV>& uv) {
  std::vector<UVBox> boxes(count);
  for (std::size_t v = 0; v < uv.size(); ++v) {
    if (patch[v] != none && std::isfinite(uv[v].u) && std::isfinite(uv[v].v)) boxes[patch[v]].include(uv[v]);
  }
  return boxes;
}

// Those that have a map: the one of most vertices, then the others by falling height.
std::vector<std::size_t> order_of(const std::vector<UVBox>& boxes) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].empty()) order.push_back(i);
  }
  if (order.empty()) return order;
  const auto most = std::max_element(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return boxes[a].vertices < boxes[b].vertices;
  });
  std::rotate(order.begin(), most, most + 1);
  std::stable_sort(order.begin() + 1, order.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].height() > boxes[b].height(); });
  return order;
}

}  // namespace

void pack_patches(std::span<const Index> patch, std::size_t patch_count, std::vector<UV>& uv, double least) {
  constexpr double between = 0.1;  // of a width or height
  constexpr double wide = 1.6;  // rows are this much wider than a square of all boxes: two discs fit one row
  const std::vector<UVBox> boxes = boxes_of(patch, patch_count, uv);
  const std::vector<std::size_t> order = order_of(boxes);
  if (order.size() < 2) return;
  double area = 0;
  for (const std::size_t i : order) area += boxes[i].width() * boxes[i].height();
  const double side = std::sqrt(area);
  const auto with_gap = [&](double extent) { return extent + std::max(between * extent, least * side); };
  const UV corner = boxes[order.front()].low;
  UV at = corner;
  double row_height = 0;
  std::vector<UV> shift(patch_count);
  for (const std::size_t i : order) {
    if (at.u > corner.u && at.u - corner.u + boxes[i].width() > wide * side) {
      at = {corner.u, at.v + with_gap(row_height)};
      row_height = 0;
    }
    if (i != order.front()) shift[i] = {at.u - boxes[i].low.u, at.v - boxes[i].low.v};
    at.u += with_gap(boxes[i].width());
    row_height = std::max(row_height, boxes[i].height());
  }
  for (std::size_t v = 0; v < uv.size(); ++v) {
    if (patch[v] != none) uv[v] = {uv[v].u + shift[patch[v]].u, uv[v].v + shift[patch[v]].v};
  }
}

}  // namespace rimline
