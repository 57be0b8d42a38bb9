// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/rims.h"

#include <algorithm>
#include <unordered_map>

#include "base/parallel.h"
#include "base/vec.h"

namespace rimline {
namespace {

Index if_selected(const Selection& selected, Index t) { return t != none && selected[t] ? t : none; }

// Splits a closed walk at each vertex that it visits again.
void split_simple(const std::vector<Index>& walk, std::vector<std::vector<Index>>& loops) {
  std::vector<Index> open;
  std::unordered_map<Index, std::size_t> position;
  for (const Index v : walk) {
    const auto [seen, is_new] = position.try_emplace(v, open.size());
    if (is_new) {
      open.push_back(v);
      continue;
    }
    const std::size_t first = seen->second;
    loops.emplace_back(open.begin() + first, open.end());
    for (std::size_t i = first + 1; i < open.size(); ++i) position.erase(open[i]);
    open.resize(first + 1);
  }
  if (open.size() >= 3) loops.push_back(std::move(open));
}

}  // namespace

Index selected_triangle(const TriangleSet& set, const Selection& selected, Index a, Index b) {
  Index found[2];
  const int count = set.edge(a, b, found);
  for (int i = 0; i < count; ++i) {
    if (selected[found[i]]) return found[i];
  }
  return none;
}

Index walk_fan(const TriangleSet& set, const Selection& selected, Index vertex, Index t, Index from,
               Index& end) {
  Index at = from;
  while (true) {
    at = set.apex(t, vertex, at);
    const Index next = at == from ? none : if_selected(selected, set.across(t, vertex, at));
    if (next == none) break;
    t = next;
  }
  end = at;
  return t;
}

std::vector<std::vector<Index>> walk_rims(const TriangleSet& set, const Selection& selected, const Run& run) {
  struct Side {
    Index triangle;
    int corner;  // that the rim's edge leaves
  };
  const bool is_all = std::find(selected.begin(), selected.end(), 0) == selected.end();
  const auto sides =
      parallel_gather<Side>(set.size(), Stage::Loops, run, [&](Index t, std::vector<Side>& found) {
        if (!selected[t]) return;
        const std::array<Index, 3>& beside = set.beside(t);
        const bool is_inside = !set.is_at_rim(t) &&
                               (is_all || (selected[beside[0]] & selected[beside[1]] & selected[beside[2]]));
        for (int i = 0; !is_inside && i < 3; ++i) {
          if (if_selected(selected, beside[i]) == none) found.push_back({t, i});
        }
      });
  std::vector<std::uint8_t> seen(set.size(), 0);  // one bit per edge of a triangle
  const auto bit_of = [&](Index t, Index a, Index b) {
    const Triangle& x = set.triangle(t);
    for (int i = 0; i < 3; ++i) {
      if (x[i] != a && x[i] != b) return 1 << i;
    }
    return 0;
  };
  std::vector<std::vector<Index>> loops;
  for (const auto& [t, i] : sides) {
    Index a = set.triangle(t)[i], b = set.triangle(t)[next_in(i, 3)], at = t;
    std::vector<Index> walk;
    while (!(seen[at] & bit_of(at, a, b))) {
      seen[at] |= bit_of(at, a, b);
      walk.push_back(a);
      Index next;
      at = walk_fan(set, selected, b, at, a, next);
      a = b;
      b = next;
    }
    if (!walk.empty()) split_simple(walk, loops);
  }
  return loops;
}

}  // namespace rimline
