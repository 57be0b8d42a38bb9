// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/weights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/vec.h"
#include "mesh/cotangent.h"

namespace rimline {

std::vector<WeightedEdge> star_edges(const Stars& stars) {
  // Four cocircular points leave a common side of length zero: they are no neighbours.
  constexpr double least = 1e-6, most = 100;
  std::vector<WeightedEdge> edges;
  edges.reserve(stars.start(stars.size()));
  for (Index i = 0; i < static_cast<Index>(stars.size()); ++i) {
    const Star star = stars[i];
    const std::span<const double> weights = stars.weights(i);
    for (std::size_t e = 0; e < star.size(); ++e) {
      if (weights[e] > least) edges.push_back({i, star[e], 0.5 * std::min(weights[e], most)});
    }
  }
  return edges;
}

void share_with_copies(Points points, const std::vector<Loop>& loops, const std::vector<Index>& original,
                       std::vector<WeightedEdge>& edges) {
  struct Pass {
    Index id, before, after;  // the point or its copy, and its neighbours along the loop
  };
  const Index first_copy = static_cast<Index>(points.size() - original.size());
  std::map<Index, std::vector<Pass>> passes;
  for (const Index v : original) passes[v];
  for (const Loop& loop : loops) {
    const std::size_t n = loop.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Index id = loop.points[i];
      const auto at = passes.find(id < first_copy ? id : original[id - first_copy]);
      if (at != passes.end())
        at->second.push_back({id, loop.points[(i + n - 1) % n], loop.points[(i + 1) % n]});
    }
  }
  const auto nearest = [&](Index v, Index other) {
    const auto at = passes.find(v);
    if (at == passes.end()) return v;
    const auto gap = [&](const Pass& pass) {
      const Point p = points[other];
      return std::min(squared_distance(points[pass.before], p), squared_distance(points[pass.after], p));
    };
    return std::min_element(at->second.begin(), at->second.end(),
                            [&](const Pass& a, const Pass& b) { return gap(a) < gap(b); })
        ->id;
  };
  for (WeightedEdge& e : edges) {
    const Index a = nearest(e.a, e.b), b = nearest(e.b, e.a);
    e.a = a;
    e.b = b;
  }
}

void join_islands(const Neighbours& neighbours, const std::vector<char>& fixed,
                  std::vector<WeightedEdge>& edges) {
  constexpr double weak = 0.01;
  while (true) {
    const std::vector<Index> apart = unreachable(make_graph(static_cast<Index>(fixed.size()), edges), fixed);
    if (apart.empty()) return;
    std::vector<char> reached(fixed.size(), 1);
    for (const Index i : apart) reached[i] = 0;
    const std::size_t before = edges.size();
    for (const Index i : apart) {
      if (i >= neighbours.size()) continue;  // the centre of a hole
      for (const Index j : neighbours.of(i)) {
        if (reached[j]) edges.push_back({i, j, weak});
      }
    }
    for (Index i = 0; i < neighbours.size(); ++i) {
      if (!reached[i]) continue;
      for (const Index j : neighbours.of(i)) {
        if (!reached[j]) edges.push_back({i, j, weak});
      }
    }
    if (edges.size() == before) return;
  }
}

void add_wheels(const std::vector<Loop>& loops, Index point_count, std::vector<WeightedEdge>& edges) {
  for (std::size_t h = 1; h < loops.size(); ++h) {
    const std::vector<Index>& rim = loops[h].points;
    // Cotangent weights of the wheel over a regular polygon; over fewer than five corners the rim's own
    // would not be positive.
    const double half = std::numbers::pi / static_cast<double>(std::max<std::size_t>(rim.size(), 5));
    for (std::size_t i = 0; i < rim.size(); ++i) {
      edges.push_back({rim[i], static_cast<Index>(point_count + h - 1), std::tan(half)});
      edges.push_back({rim[i], rim[next_in(i, rim.size())], 0.5 / std::tan(2 * half)});
    }
  }
}

double cotangent_weight(Points points, const Triangulation& mesh, Index t, int c,
                        std::span<const double> evenness) {
  constexpr double least = 1e-3, most = 100;
  const Triangle& v = mesh.triangles[t];
  const Index a = v[next(c)], b = v[previous(c)], other = mesh.adjacent[t][c];
  double weight = cotangent(points[v[c]], points[a], points[b]);
  if (other != none)
    weight += cotangent(points[mesh.triangles[other][mesh.corner_across(other, t)]], points[a], points[b]);
  weight = std::clamp(0.5 * weight, least, most);
  if (!evenness.empty()) weight = std::pow(weight, 1 - std::max(evenness[a], evenness[b]));
  return weight;
}

}  // namespace rimline
