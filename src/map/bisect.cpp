// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/bisect.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/vec.h"
#include "map/seam_paths.h"

namespace rimline {
namespace {

using Labels = std::vector<Index>;

// Per triangle, the share of the way from one vertex to the other.
std::vector<double> share_of_way(const OpenMesh& open, Index vertex) {
  const Graph graph = seam_graph(open);
  const SeamPaths from = paths_to(graph, vertex), to = paths_to(graph, farthest(from));
  std::vector<double> share;
  for (const Triangle& t : open.mesh.triangles) {
    double sum = 0;
    for (const Index v : t) {
      const double way = from.cost[v] + to.cost[v];
      sum += way > 0 ? from.cost[v] / way : 0;
    }
    share.push_back(sum / 3);
  }
  return share;
}

// Triangles in the order of their shares, with the area up to each of them.
struct Ranking {
  std::vector<Index> order, rank;
  std::vector<double> area;
};

Ranking rank(const OpenMesh& open, const std::vector<double>& share) {
  Ranking ranking;
  ranking.order.resize(share.size());
  std::iota(ranking.order.begin(), ranking.order.end(), Index{0});
  std::ranges::stable_sort(ranking.order, [&](Index a, Index b) { return share[a] < share[b]; });
  ranking.rank.resize(share.size());
  double area = 0;
  for (std::size_t i = 0; i < ranking.order.size(); ++i) {
    ranking.rank[ranking.order[i]] = static_cast<Index>(i);
    ranking.area.push_back(area += triangle_area(open.points, open.mesh.triangles[ranking.order[i]]));
  }
  return ranking;
}

// The number of triangles before the cut, in their order: the cost of each cut is summed along the order.
std::size_t best_cut(const OpenMesh& open, const Ranking& ranking) {
  constexpr double least = 0.1;  // of the area on either side
  const std::size_t count = ranking.order.size();
  std::vector<double> change(count + 1, 0);
  for (Index t = 0; t < open.mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = open.mesh.adjacent[t][c];
      if (other == none || other < t) continue;
      const auto [low, high] = std::minmax(ranking.rank[t], ranking.rank[other]);
      const double cost = seam_cost(open, t, c);
      change[low + 1] += cost;
      change[high + 1] -= cost;
    }
  }
  const double whole = ranking.area.back();
  std::size_t best = count / 2;
  double best_ratio = -1, cost = 0;
  for (std::size_t cut = 1; cut < count; ++cut) {
    cost += change[cut];
    const double lesser = std::min(ranking.area[cut - 1], whole - ranking.area[cut - 1]);
    if (!(lesser >= least * whole)) continue;
    const double ratio = cost / std::sqrt(lesser);
    if (best_ratio >= 0 && ratio >= best_ratio) continue;
    best_ratio = ratio;
    best = cut;
  }
  return std::max<std::size_t>(best, 1);
}

// Moves triangles to the other side where that shortens the cut.
void straighten(const OpenMesh& open, Labels& label) {
  constexpr int sweeps = 4;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Index t = 0; t < open.mesh.size(); ++t) {
      double gain = 0;
      int others = 0;
      for (int c = 0; c < 3; ++c) {
        const Index other = open.mesh.adjacent[t][c];
        if (other == none) continue;
        const bool apart = label[other] != label[t];
        others += apart;
        gain += (apart ? 1 : -1) * seam_cost(open, t, c);
      }
      if (others >= 2 && gain > 0) label[t] = 1 - label[t];
    }
  }
}

// Of the connected parts of one label only the largest keeps it.
void drop_islands(const OpenMesh& open, Labels& label) {
  const Triangulation& mesh = open.mesh;
  Labels part(label.size(), none);
  std::vector<Index> size, sign, queue;
  for (Index first = 0; first < mesh.size(); ++first) {
    if (part[first] != none) continue;
    const auto id = static_cast<Index>(size.size());
    size.push_back(0);
    sign.push_back(label[first]);
    part[first] = id;
    queue.assign(1, first);
    while (!queue.empty()) {
      const Index t = queue.back();
      queue.pop_back();
      ++size[id];
      for (const Index other : mesh.adjacent[t]) {
        if (other == none || part[other] != none || label[other] != label[t]) continue;
        part[other] = id;
        queue.push_back(other);
      }
    }
  }
  std::array<Index, 2> largest{none, none};
  for (Index id = 0; id < static_cast<Index>(size.size()); ++id) {
    Index& best = largest[sign[id]];
    if (best == none || size[id] > size[best]) best = id;
  }
  for (std::size_t t = 0; t < label.size(); ++t) {
    if (part[t] != largest[label[t]]) label[t] = 1 - label[t];
  }
}

// Of the area that has the label 0.
double share_of(const OpenMesh& open, const Labels& label) {
  double own = 0, whole = 0;
  for (std::size_t t = 0; t < label.size(); ++t) {
    const double area = triangle_area(open.points, open.mesh.triangles[t]);
    whole += area;
    if (label[t] == 0) own += area;
  }
  return whole > 0 ? own / whole : 0.5;
}

// Triangle by triangle over sides, from the first in the order, until half of them are in.
Labels grown_half(const OpenMesh& open, const Ranking& ranking) {
  Labels label(ranking.order.size(), 1);
  std::vector<Index> front{ranking.order.front()};
  label[front.front()] = 0;
  for (std::size_t i = 0; i < front.size() && 2 * front.size() < label.size(); ++i) {
    for (const Index other : open.mesh.adjacent[front[i]]) {
      if (other == none || label[other] == 0) continue;
      label[other] = 0;
      front.push_back(other);
    }
  }
  return label;
}

}  // namespace

std::vector<Index> bisect(const OpenMesh& open, Index vertex) {
  constexpr double least = 0.05;  // of the area on either side: less comes of a cut in many pieces
  const Ranking ranking = rank(open, share_of_way(open, vertex));
  const std::size_t cut = best_cut(open, ranking);
  Labels label(ranking.order.size(), 1);
  for (std::size_t i = 0; i < cut; ++i) label[ranking.order[i]] = 0;
  straighten(open, label);
  drop_islands(open, label);
  if (const double share = share_of(open, label); share < least || share > 1 - least) {
    label = grown_half(open, ranking);
    drop_islands(open, label);
  }
  if (std::ranges::adjacent_find(label, std::not_equal_to{}) == label.end())
    label[ranking.order.front()] = 1 - label[ranking.order.front()];
  return label;
}

std::vector<OpenMesh> halves(const OpenMesh& open, Index vertex) {
  return open_parts(open, bisect(open, vertex));
}

}  // namespace rimline
