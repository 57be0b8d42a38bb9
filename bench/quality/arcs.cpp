// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/arcs.h"

#include <algorithm>
#include <map>
#include <optional>

namespace rimline::bench {
namespace {

constexpr double largest = 1.7;  // spacings

double circumradius(Point a, Point b, Point c) {
  const double area = norm(cross(b - a, c - a)) / 2;
  return area > 0 ? distance(a, b) * distance(b, c) * distance(c, a) / (4 * area) : 1e300;
}

// The neighbours on both sides of the only opening of the fan, if there is just one.
std::optional<std::pair<Index, Index>> opening(Points points, Index at, Star star, double reach) {
  std::optional<std::pair<Index, Index>> found;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Index a = star[i], b = star[(i + 1) % star.size()];
    if (a != none && b != none && circumradius(points[at], points[a], points[b]) <= reach) continue;
    // An opening may span several too large triangles: it begins after the last small one.
    const std::size_t n = star.size();
    const Index before = star[(i + n - 1) % n];
    const bool begins =
        a != none && before != none && circumradius(points[at], points[before], points[a]) <= reach;
    if (!begins) continue;
    if (found) return std::nullopt;
    std::size_t end = (i + 1) % n;
    while (star[end] == none || star[(end + 1) % n] == none ||
           circumradius(points[at], points[star[end]], points[star[(end + 1) % n]]) > reach) {
      end = (end + 1) % n;
    }
    found = {a, star[end]};
  }
  return found;
}

}  // namespace

EdgeSet mutual_edges(Points points, const Stars& stars, const std::vector<double>& spacing) {
  std::vector<Edge> named;
  for (Index p = 0; p < static_cast<Index>(stars.size()); ++p) {
    const auto found = opening(points, p, stars[p], largest * spacing[p]);
    if (!found) continue;
    named.push_back(Edge::of(p, found->first));
    named.push_back(Edge::of(p, found->second));
  }
  std::sort(named.begin(), named.end());
  EdgeSet mutual;
  for (std::size_t i = 0; i + 1 < named.size(); ++i) {
    if (named[i] == named[i + 1] && (mutual.empty() || mutual.back() != named[i])) mutual.push_back(named[i]);
  }
  return mutual;
}

LoopIds closed_arcs(const EdgeSet& edges) {
  LoopIds loops;
  for (const EdgeSet& piece : connected_pieces(edges)) {
    std::map<Index, std::vector<Index>> next;
    for (const Edge& e : piece) {
      next[e.a].push_back(e.b);
      next[e.b].push_back(e.a);
    }
    const bool closed =
        std::all_of(next.begin(), next.end(), [](const auto& n) { return n.second.size() == 2; });
    if (!closed || next.size() < 3) continue;
    std::vector<Index> loop{piece.front().a, piece.front().b};
    while (true) {
      const auto& [p, q] = std::pair(next[loop.back()][0], next[loop.back()][1]);
      const Index step = p == loop[loop.size() - 2] ? q : p;
      if (step == loop.front()) break;
      loop.push_back(step);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace rimline::bench
