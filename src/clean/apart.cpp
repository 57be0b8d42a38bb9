// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/apart.h"

#include <algorithm>

#include "base/model.h"
#include "base/model_clean.h"
#include "base/parallel.h"
#include "base/union_find.h"

namespace rimline {
namespace {

// Whether the gap around a point is wider than its neighbours' spacing explains.
bool is_alone(Points points, const Neighbours& neighbours, const std::vector<double>& scale, Index i,
              const std::vector<char>& left_out) {
  double widest = scale[i], nearest = 0;
  int met = 0;
  for (const Index j : neighbours.of(i)) {
    if (left_out[j]) continue;
    if (met == 0) nearest = distance(points[i], points[j]);
    if (nearest <= model::apart_alone * widest) return false;
    widest = std::max(widest, scale[j]);
    if (++met == model::apart_asked) break;
  }
  return nearest > model::apart_alone * widest;
}

struct Edge {
  Index a, b;
};

// The groups that gaps part. Edges within a block of ids are joined by its own thread, which touches no other
// block's sets; those between blocks, few as ids follow a curve, afterwards.
UnionFind groups_of(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                    const std::vector<char>& left_out, const Run& run) {
  constexpr std::size_t block = 16384;  // [speed]
  UnionFind groups(points.size());
  const int count = std::min(model::more_neighbours, neighbours.k);
  const auto is_joined = [&](Index i, Index j) {
    return !left_out[j] && distance(points[i], points[j]) <= model::apart_gap * std::max(scale[i], scale[j]);
  };
  const std::size_t blocks = (points.size() + block - 1) / block;
  std::vector<std::vector<Edge>> between(blocks);
  parallel_tasks(blocks, Stage::Neighbours, run.without_progress(), [&](std::size_t b) {
    const auto begin = static_cast<Index>(b * block);
    const auto end = static_cast<Index>(std::min(points.size(), (b + 1) * block));
    for (Index i = begin; i < end; ++i) {
      if (left_out[i]) continue;
      for (const Index j : neighbours.of(i, count)) {
        if (j < begin || j >= end) {
          between[b].push_back({i, j});
        } else if (groups.find(i) != groups.find(j) && is_joined(i, j)) {
          groups.join(i, j);
        }
      }
    }
  });
  run.check_cancel();
  for (const std::vector<Edge>& edges : between) {
    for (const auto [i, j] : edges) {
      if (groups.find(i) != groups.find(j) && is_joined(i, j)) groups.join(i, j);
    }
  }
  return groups;
}

}  // namespace

std::vector<char> lies_apart(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                             const std::vector<char>& left_out, const Run& run) {
  UnionFind groups = groups_of(points, neighbours, scale, left_out, run);
  const double most = std::min(model::apart_most, model::apart_share * static_cast<double>(points.size()));
  std::vector<char> apart(points.size());
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
    apart[i] = !left_out[i] && static_cast<double>(groups.size_of(i)) <= most;
  parallel_for_each(points.size(), Stage::Neighbours, run, [&](Index i) {
    if (!left_out[i] && !apart[i]) apart[i] = is_alone(points, neighbours, scale, i, left_out);
  });
  return apart;
}

}  // namespace rimline
