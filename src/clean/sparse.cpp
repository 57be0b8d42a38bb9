// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/sparse.h"

#include <algorithm>
#include <map>

#include "base/model.h"
#include "base/model_clean.h"
#include "base/parallel.h"
#include "clean/gap_groups.h"
#include "clean/own_scale.h"
#include "points/kd_tree.h"

namespace rimline {
namespace {

constexpr int points_in_leaf = 40;  // [speed]

using Group = std::vector<Index>;

// Whether a point is farther from its neighbours than most of the points around are from theirs.
bool is_sparse(const Neighbours& neighbours, const std::vector<double>& spacing, Index i) {
  const double most = spacing[i] / model::sparse_ratio;
  const auto denser = std::ranges::count_if(neighbours.of(i), [&](Index j) { return spacing[j] <= most; });
  return static_cast<double>(denser) >= model::sparse_around * neighbours.k;
}

// The groups of the points that are marked.
std::vector<Group> groups_of(UnionFind& joined, const std::vector<char>& is_in) {
  std::map<Index, Group> of_root;
  for (Index i = 0; i < static_cast<Index>(is_in.size()); ++i) {
    if (is_in[i]) of_root[joined.find(i)].push_back(i);
  }
  std::vector<Group> all;
  for (auto& [root, group] : of_root) all.push_back(std::move(group));
  return all;
}

bool is_surface(const Group& group, Points points, const std::vector<double>& spacing, const KdTree& tree) {
  const auto on = std::ranges::count_if(
      group, [&](Index i) { return fits_at_own_scale(tree, points, spacing, i, spacing[i]); });
  return static_cast<double>(on) >= model::sparse_on_surface * static_cast<double>(group.size());
}

// The suspects whose groups are no parts of a surface.
std::vector<char> off_surfaces(UnionFind joined, std::vector<char> suspects, Points points,
                               const std::vector<double>& spacing, const Run& run) {
  const auto count = std::ranges::count(suspects, 1);
  if (count == 0 || static_cast<double>(count) > model::stray_most_share * static_cast<double>(points.size()))
    return std::vector<char>(points.size());
  const std::vector<Group> groups = groups_of(joined, suspects);
  const KdTree tree(points, points_in_leaf, run);
  parallel_tasks(groups.size(), Stage::Neighbours, run.without_progress(), [&](std::size_t g) {
    if (!is_surface(groups[g], points, spacing, tree)) return;
    for (const Index i : groups[g]) suspects[i] = 0;
  });
  run.check_cancel();
  return suspects;
}

}  // namespace

std::vector<char> lies_in_sparse_group(Points points, const Neighbours& neighbours,
                                       const std::vector<double>& spacing, const Run& run) {
  const auto is_joined = [&](Index i, Index j) {
    return distance(points[i], points[j]) <= model::sparse_gap * std::min(spacing[i], spacing[j]);
  };
  std::vector<char> suspects(points.size());
  UnionFind joined = gap_groups(points.size(), neighbours, model::more_neighbours, suspects, is_joined, run);
  const double most = model::sparse_most * static_cast<double>(points.size());
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
    suspects[i] = joined.size_of(i) > 1 && static_cast<double>(joined.size_of(i)) <= most;
  for (const Group& group : groups_of(joined, suspects)) {
    const auto sparse =
        std::ranges::count_if(group, [&](Index i) { return is_sparse(neighbours, spacing, i); });
    if (2 * sparse >= static_cast<std::ptrdiff_t>(group.size())) continue;
    for (const Index i : group) suspects[i] = 0;
  }
  return off_surfaces(std::move(joined), std::move(suspects), points, spacing, run);
}

}  // namespace rimline
