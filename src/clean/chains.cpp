// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean/chains.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/model_clean.h"
#include "base/parallel.h"
#include "base/vec.h"

namespace rimline {
namespace {

using Ids = std::vector<Index>;

// A set of points from which some were removed.
struct Left {
  Points points;
  const Neighbours& neighbours;
  const std::vector<double>& scale;
  std::vector<char> gone;

  // The nearest remaining point, or none.
  Index nearest(Index i) const {
    for (const Index j : neighbours.of(i)) {
      if (!gone[j]) return j;
    }
    return none;
  }

  // Calls visit(direction) for each remaining point within reach.
  template <class Visit>
  void around(Index i, double reach, const Visit& visit) const {
    for (const Index j : neighbours.of(i)) {
      if (gone[j]) continue;
      const Point d = points[j] - points[i];
      if (norm(d) > reach) break;
      visit(unit(d));
    }
  }

  // Whether two within reach are farther apart than any two in a cone of that cosine.
  bool sees_apart(Index i, double reach, double least_cosine) const {
    const double least = 2 * least_cosine * least_cosine - 1 - 1e-9;  // of the doubled angle [guard]
    const double farthest = (1 - 1e-9) * reach * reach;               // [guard]
    Point first;
    double length = 0;  // of it, squared
    for (const Index j : neighbours.of(i)) {
      if (gone[j]) continue;
      const Point d = points[j] - points[i];
      const double squared = dot(d, d);
      if (squared > farthest) return false;
      if (length == 0) {
        first = d;
        length = squared;
      }
      const double along = dot(first, d);
      if (along < 0 || along * along < least * least * squared * length) return true;
    }
    return false;
  }

  // Whether all within reach lie in one cone.
  bool sees_cone(Index i, double reach, double least_cosine) const {
    Point axis;
    around(i, reach, [&](Point d) { axis = axis + d; });
    const Point along = unit(axis);
    bool all = true;
    around(i, reach, [&](Point d) { all = all && dot(d, along) >= least_cosine; });
    return all;
  }

  bool is_end(Index i) const {
    const Index first = nearest(i);
    if (first == none) return false;
    const double apart = distance(points[i], points[first]);
    const double reach = std::max(model::chain_reach * scale[i], model::chain_reach_nearest * apart);
    return !sees_apart(i, reach, model::chain_cone) && sees_cone(i, reach, model::chain_cone);
  }
};

// Removes the chain that ends in a point, if it is long enough.
Ids peel(Index i, Left& left) {
  Ids chain;
  while (i != none && !left.gone[i] && left.is_end(i)) {
    left.gone[i] = 1;
    chain.push_back(i);
    i = left.nearest(i);
  }
  if (chain.size() >= model::chain_least) return chain;
  for (const Index j : chain) left.gone[j] = 0;
  return {};
}

// The points that a chain passes before it reaches the surface, from which they stick out.
Ids root_of(const Ids& chain, Left& left) {
  const double step =
      distance(left.points[chain.front()], left.points[chain.back()]) / static_cast<double>(chain.size() - 1);
  const Point along = unit(left.points[chain.back()] - left.points[chain.front()]);
  Ids root, taken;
  for (Index at = chain.back(); root.size() < model::chain_most_root;) {
    const Index next = left.nearest(at);
    if (next == none) break;
    const Point d = left.points[next] - left.points[at];
    if (norm(d) > model::chain_uneven * step || dot(unit(d), along) < model::chain_cone) break;
    left.gone[next] = 1;
    taken.push_back(next);
    if (!left.sees_cone(next, model::chain_root_reach * left.scale[next], model::chain_root_cone)) break;
    root.push_back(at = next);
  }
  for (const Index i : taken) left.gone[i] = 0;  // other chains still see them
  return root;
}

bool is_straight(const Ids& chain, Points points) {
  const Point from = points[chain.front()], whole = points[chain.back()] - from;
  return std::ranges::all_of(chain, [&](Index i) {
    return norm(cross(points[i] - from, unit(whole))) <= model::chain_bend * norm(whole);
  });
}

// Whether half of a chain's points have others beside them: near ones, or those of other chains.
bool has_sides(const Ids& chain, const Left& left, const std::vector<Index>& chain_of,
               const std::vector<char>& left_out) {
  const Point along = unit(left.points[chain.back()] - left.points[chain.front()]);
  std::size_t beside = 0;
  for (const Index i : chain) {
    beside += std::ranges::any_of(left.neighbours.of(i), [&](Index j) {
      if (left_out[j] || chain_of[j] == chain_of[i]) return false;
      const Point d = left.points[j] - left.points[i];
      if (std::abs(dot(unit(d), along)) > model::chain_side) return false;
      return chain_of[j] != none || norm(d) <= model::chain_beside * std::max(left.scale[i], left.scale[j]);
    });
  }
  return 2 * beside >= chain.size();
}

std::vector<Ids> find_chains(Left& left, const Run& run) {
  std::vector<char> is_end(left.points.size());
  parallel_for_each(left.points.size(), Stage::Neighbours, run,
                    [&](Index i) { is_end[i] = !left.gone[i] && left.is_end(i); });
  std::vector<Ids> chains;
  for (Index i = 0; i < static_cast<Index>(is_end.size()); ++i) {
    if (!is_end[i]) continue;
    if (Ids chain = peel(i, left); !chain.empty()) chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace

std::vector<char> lies_on_chain(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                                const std::vector<char>& left_out, const Run& run) {
  Left left{points, neighbours, scale, left_out};
  const std::vector<Ids> chains = find_chains(left, run);
  std::vector<char> found(points.size());
  std::vector<Index> chain_of(points.size(), none);
  std::size_t all = 0;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    for (const Index i : chains[c]) chain_of[i] = static_cast<Index>(c);
    all += chains[c].size();
  }
  if (static_cast<double>(all) > model::chain_most_share * static_cast<double>(points.size())) return found;
  for (const Ids& chain : chains) {
    if (!is_straight(chain, points) || has_sides(chain, left, chain_of, left_out)) continue;
    for (const Index i : chain) found[i] = 1;
    for (const Index i : root_of(chain, left)) found[i] = 1;
  }
  return found;
}

}  // namespace rimline
