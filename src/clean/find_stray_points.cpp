// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "base/model.h"
#include "base/model_clean.h"
#include "base/parallel.h"
#include "base/quantile.h"
#include "clean/apart.h"
#include "clean/chains.h"
#include "clean/off_surface.h"
#include "clean/own_scale.h"
#include "clean/sparse.h"
#include "clean/usual_spacing.h"
#include "points/kd_tree.h"
#include "rimline/clean.h"

namespace rimline {
namespace {

constexpr int points_in_leaf = 40;  // [speed]

std::vector<Index> ids_of(const std::vector<char>& is_in) {
  std::vector<Index> ids;
  for (Index i = 0; i < static_cast<Index>(is_in.size()); ++i) {
    if (is_in[i]) ids.push_back(i);
  }
  return ids;
}

// Whether some of the points around a point are nearly as far from their neighbours as it is: the density
// varies there.
bool is_in_graded(const Neighbours& neighbours, const std::vector<double>& spacing,
                  const std::vector<double>& scale, Index i, double nearest) {
  const double wide = std::max(model::graded_share * nearest, model::graded_least * scale[i]);
  const auto around = neighbours.of(i, std::min(model::few_neighbours, neighbours.k));
  return std::ranges::count_if(around, [&](Index j) { return spacing[j] >= wide; }) >= model::graded_count;
}

// The points that are not part of the surface at their own scale either. `made`: the tree of the points,
// built at its first use.
std::vector<char> confirmed(std::vector<char> suspects, Points points, const Neighbours& neighbours,
                            const std::vector<double>& spacing, const std::vector<double>& scale,
                            std::optional<KdTree>& made, const Run& run) {
  const std::vector<Index> ids = ids_of(suspects);
  if (ids.empty()) return suspects;
  if (!made) made.emplace(points, points_in_leaf, run);
  const KdTree& tree = *made;
  parallel_tasks(ids.size(), Stage::Neighbours, run, [&](std::size_t s) {
    const Index i = ids[s];
    const double nearest = distance_to(points, neighbours, i, 0);
    if (is_in_graded(neighbours, spacing, scale, i, nearest)) suspects[i] = 0;
    if (nearest > model::own_coarser * scale[i] && fits_at_own_scale(tree, points, spacing, i, nearest))
      suspects[i] = 0;
  });
  run.check_cancel();
  return suspects;
}

std::vector<char> either(std::vector<char> a, const std::vector<char>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<char>(a[i] | b[i]);
  return a;
}

// Whether the spacing varies so much over the set that a true point may be as isolated as a stray one.
bool is_graded(std::vector<double> scale) {
  constexpr double low = 0.05, high = 0.95;  // [layout] shares
  return quantile(scale, high) > model::stray_most_graded * quantile(scale, low);
}

}  // namespace

std::vector<Index> all_of(const StrayPoints& stray) {
  std::vector<Index> all = stray.off_surface;
  all.insert(all.end(), stray.on_line.begin(), stray.on_line.end());
  all.insert(all.end(), stray.apart.begin(), stray.apart.end());
  std::ranges::sort(all);
  return all;
}

StrayPoints find_stray_points(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                              const Run& run) {
  if (points.size() < model::stray_fewest_points) return {};
  // Sparse points would spoil all measures of the others, so they go first.
  if (auto sparse = ids_of(lies_in_sparse_group(points, neighbours, spacing, run)); !sparse.empty())
    return {{}, {}, std::move(sparse)};
  const std::vector<double> scale = usual_spacing(neighbours, spacing, run);
  const bool graded = is_graded(scale);
  std::optional<KdTree> tree;
  const std::vector<char> off = graded ? std::vector<char>(points.size())
                                       : confirmed(lies_off_surface(points, neighbours, scale, run), points,
                                                   neighbours, spacing, scale, tree, run);
  const std::vector<char> on_line = lies_on_chain(points, neighbours, scale, off, run);
  const std::vector<char> apart =
      confirmed(lies_apart(points, neighbours, scale, either(off, on_line), !graded, run), points, neighbours,
                spacing, scale, tree, run);
  StrayPoints stray{ids_of(off), ids_of(on_line), ids_of(apart)};
  const auto most = static_cast<std::size_t>(model::stray_most_share * static_cast<double>(points.size()));
  return all_of(stray).size() > most ? StrayPoints{} : stray;
}

}  // namespace rimline
