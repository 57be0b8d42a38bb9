// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/outline_crossings.h"

#include <algorithm>
#include <tuple>

#include "base/vec.h"

namespace rimline {
namespace {

struct OutlineEdge {
  Index from, to;
  UV a, b;
  double left, right, low, high;
};

bool meet(const OutlineEdge& e, const OutlineEdge& f) {
  if (e.high < f.low || f.high < e.low) return false;
  if (e.from == f.from || e.from == f.to || e.to == f.from || e.to == f.to) return false;
  return twice_area(e.a, e.b, f.a) * twice_area(e.a, e.b, f.b) <= 0 &&
         twice_area(f.a, f.b, e.a) * twice_area(f.a, f.b, e.b) <= 0;
}

}  // namespace

std::vector<Index> crossing_points(const std::vector<Loop>& loops, const std::vector<UV>& uv) {
  std::vector<OutlineEdge> edges;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Index from = loop.points[i], to = loop.points[next_in(i, loop.points.size())];
      const UV a = uv[from], b = uv[to];
      edges.push_back(
          {from, to, a, b, std::min(a.u, b.u), std::max(a.u, b.u), std::min(a.v, b.v), std::max(a.v, b.v)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const OutlineEdge& e, const OutlineEdge& f) {
    return std::tie(e.left, e.from) < std::tie(f.left, f.from);
  });
  std::vector<Index> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].left <= edges[i].right; ++j) {
      if (meet(edges[i], edges[j]))
        found.insert(found.end(), {edges[i].from, edges[i].to, edges[j].from, edges[j].to});
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace rimline
