// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/loop_score.h"

#include <algorithm>

#include "quality/crossings.h"
#include "quality/nearest.h"

namespace rimline::bench {
namespace {

constexpr std::uint8_t not_asked = 2;
constexpr std::size_t longest_count = 4;

NearestPoint tree_of(const Case& c, std::span<const Index> ids) {
  std::vector<Point> points;
  for (const Index id : ids) points.push_back(c.points[id]);
  return NearestPoint(std::move(points));
}

// Share of `ids` that have a point of `others` within their own spacing.
double share_near(const Case& c, std::span<const Index> ids, std::span<const Index> others) {
  if (ids.empty() || others.empty()) return ids.empty() ? 1 : 0;
  const NearestPoint tree = tree_of(c, others);
  const auto hits = std::count_if(ids.begin(), ids.end(),
                                  [&](Index id) { return tree.to(c.points[id]).distance <= c.spacing[id]; });
  return static_cast<double>(hits) / static_cast<double>(ids.size());
}

std::vector<Index> flagged(const std::vector<std::uint8_t>& flags) {
  std::vector<Index> ids;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] == 1) ids.push_back(static_cast<Index>(i));
  }
  return ids;
}

std::size_t count_flagged(std::span<const Index> ids, const std::vector<std::uint8_t>& flags) {
  return std::count_if(ids.begin(), ids.end(), [&](Index id) { return flags[id] == 1; });
}

void put(Metrics& m, const std::string& what, const F1& score) {
  m[what + "_precision"] = score.precision;
  m[what + "_recall"] = score.recall;
  m[what + "_f1"] = score.f1;
}

EdgeSet union_of(const std::vector<EdgeSet>& sets) {
  std::vector<Edge> all;
  for (const EdgeSet& set : sets) all.insert(all.end(), set.begin(), set.end());
  return make_set(std::move(all));
}

double length_of(const Case& c, std::span<const Index> loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += distance(c.points[loop[i]], c.points[loop[(i + 1) % loop.size()]]);
  }
  return length;
}

double length_of(const Case& c, const EdgeSet& edges) {
  double length = 0;
  for (const Edge& e : edges) length += distance(c.points[e.a], c.points[e.b]);
  return length;
}

bool is_simple(std::vector<Index> loop) {
  std::sort(loop.begin(), loop.end());
  return std::adjacent_find(loop.begin(), loop.end()) == loop.end();
}

std::vector<Index> points_of(const EdgeSet& edges) {
  std::vector<Index> ids;
  for (const Edge& e : edges) ids.insert(ids.end(), {e.a, e.b});
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void score_longest(const Case& c, const LoopIds& loops, const std::vector<EdgeSet>& found, Metrics& m) {
  std::vector<EdgeSet> longest = c.loops;
  std::stable_sort(longest.begin(), longest.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  longest.resize(std::min(longest.size(), longest_count));
  for (std::size_t i = 0; i < longest.size(); ++i) {
    const std::vector<Index> ids = points_of(longest[i]);
    double edges = 0, within = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const auto common = static_cast<double>(count_common(longest[i], found[l]));
      edges = std::max(edges, common / static_cast<double>(longest[i].size()));
      within = std::max(within, share_near(c, ids, loops[l]));
    }
    m["longest_loop_" + std::to_string(i + 1)] = edges;
    m["longest_within_" + std::to_string(i + 1)] = within;
  }
}

void score_missed(const Case& c, const LoopIds& loops, Metrics& m) {
  constexpr double half = 0.5;
  std::vector<Index> all_found, all_true;
  for (const auto& loop : loops) all_found.insert(all_found.end(), loop.begin(), loop.end());
  for (const EdgeSet& loop : c.loops) {
    for (const Index id : points_of(loop)) all_true.push_back(id);
  }
  m["loops_missed"] =
      static_cast<double>(std::count_if(c.loops.begin(), c.loops.end(), [&](const auto& loop) {
        return share_near(c, points_of(loop), all_found) < half;
      }));
  m["loops_false"] = static_cast<double>(std::count_if(
      loops.begin(), loops.end(), [&](const auto& loop) { return share_near(c, loop, all_true) < half; }));
}

void score_edges(const Case& c, const std::vector<EdgeSet>& found, Metrics& m) {
  const EdgeSet all_found = union_of(found), all_true = union_of(c.loops);
  put(m, "edges", f1_of(count_common(all_found, all_true), all_found.size(), all_true.size()));
  const auto exact = std::count_if(c.loops.begin(), c.loops.end(), [&](const EdgeSet& loop) {
    return std::find(found.begin(), found.end(), loop) != found.end();
  });
  m["loops_true"] = static_cast<double>(c.loops.size());
  m["loops_right"] = found.size() == c.loops.size();
  m["loops_exact"] = static_cast<double>(exact);
  m["all_exact"] = found.size() == c.loops.size() && static_cast<std::size_t>(exact) == c.loops.size();
  m["crossings_of_truth"] = static_cast<double>(count_crossings(c, all_true));
  if (const double truth = length_of(c, all_true); truth > 0) m["length_over_truth"] = m["length"] / truth;
}

}  // namespace

std::vector<Index> points_of(const LoopIds& loops) {
  std::vector<Index> ids;
  for (const auto& loop : loops) ids.insert(ids.end(), loop.begin(), loop.end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

bool is_covered(const Case& c, const EdgeSet& loop, std::span<const Index> found) {
  constexpr double enough = 0.9;
  return share_near(c, points_of(loop), found) >= enough;
}

Metrics score_points(const Case& c, std::span<const Index> found) {
  if (c.boundary.empty()) return {};
  Metrics m;
  const std::vector<Index> truth = flagged(c.boundary), rim = flagged(c.rim);
  std::vector<Index> asked;
  std::copy_if(found.begin(), found.end(), std::back_inserter(asked),
               [&](Index id) { return c.boundary[id] != not_asked; });
  put(m, "points", f1_of(count_flagged(asked, c.boundary), asked.size(), truth.size()));
  m["points_true"] = static_cast<double>(truth.size());
  m["rim_points_f1"] = f1_of(count_flagged(asked, c.rim), asked.size(), rim.size()).f1;
  m["points_f1_within_one_spacing"] =
      f1_of_shares(share_near(c, asked, truth), share_near(c, truth, asked)).f1;
  return m;
}

Metrics score_loops(const Case& c, const LoopIds& loops) {
  Metrics m = score_points(c, points_of(loops));
  std::vector<EdgeSet> found;
  double length = 0;
  for (const auto& loop : loops) {
    found.push_back(edges_of_loop(loop));
    length += length_of(c, loop);
  }
  m["loops_found"] = static_cast<double>(loops.size());
  m["length"] = length;
  m["simple"] = std::all_of(loops.begin(), loops.end(), is_simple);
  m["crossings"] = static_cast<double>(count_crossings(c, union_of(found)));
  if (c.has_loops) {
    score_edges(c, found, m);
    score_missed(c, loops, m);
    score_longest(c, loops, found, m);
  }
  return m;
}

}  // namespace rimline::bench
