// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/apart.h"

#include <algorithm>

#include "base/model.h"
#include "base/model_clean.h"
#include "base/parallel.h"
#include "clean/gap_groups.h"

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

}  // namespace

std::vector<char> lies_apart(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                             const std::vector<char>& left_out, bool singles, const Run& run) {
  const auto is_joined = [&](Index i, Index j) {
    return distance(points[i], points[j]) <= model::apart_gap * std::max(scale[i], scale[j]);
  };
  UnionFind groups = gap_groups(points.size(), neighbours, model::more_neighbours, left_out, is_joined, run);
  const double most = std::min(model::apart_most, model::apart_share * static_cast<double>(points.size()));
  std::vector<char> apart(points.size());
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
    apart[i] = !left_out[i] && static_cast<double>(groups.size_of(i)) <= most &&
               (singles || static_cast<std::size_t>(groups.size_of(i)) >= model::apart_fewest_graded);
  if (!singles) return apart;
  parallel_for_each(points.size(), Stage::Neighbours, run, [&](Index i) {
    if (!left_out[i] && !apart[i]) apart[i] = is_alone(points, neighbours, scale, i, left_out);
  });
  return apart;
}

}  // namespace rimline
