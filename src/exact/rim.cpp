// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rim.h"

#include <algorithm>
#include <unordered_map>

#include "parallel.h"

namespace rimline::exact {
namespace {

Index if_kept(const Kept& kept, Index t) { return t != none && kept[t] ? t : none; }

// Cuts a closed walk at each vertex it comes back to.
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

Index kept_triangle(const Complex& complex, const Kept& kept, Index a, Index b) {
  Index found[2];
  const int count = complex.edge(a, b, found);
  for (int i = 0; i < count; ++i) {
    if (kept[found[i]]) return found[i];
  }
  return none;
}

Index walk_fan(const Complex& complex, const Kept& kept, Index vertex, Index t, Index from, Index& end) {
  Index at = from;
  while (true) {
    at = complex.apex(t, vertex, at);
    const Index next = at == from ? none : if_kept(kept, complex.across(t, vertex, at));
    if (next == none) break;
    t = next;
  }
  end = at;
  return t;
}

std::vector<std::vector<Index>> walk_rims(const Complex& complex, const Kept& kept, const Run& run) {
  struct Side {
    Index triangle;
    int corner;  // that the rim's edge leaves
  };
  const bool is_all = std::find(kept.begin(), kept.end(), 0) == kept.end();
  const auto sides =
      parallel_gather<Side>(complex.size(), Stage::Loops, run, [&](Index t, std::vector<Side>& found) {
        if (!kept[t]) return;
        const std::array<Index, 3>& beside = complex.beside(t);
        const bool is_inside =
            !complex.is_at_rim(t) && (is_all || (kept[beside[0]] & kept[beside[1]] & kept[beside[2]]));
        for (int i = 0; !is_inside && i < 3; ++i) {
          if (if_kept(kept, beside[i]) == none) found.push_back({t, i});
        }
      });
  std::vector<std::uint8_t> seen(complex.size(), 0);  // one bit per edge of a triangle
  const auto bit_of = [&](Index t, Index a, Index b) {
    const Triangle& x = complex.triangle(t);
    for (int i = 0; i < 3; ++i) {
      if (x[i] != a && x[i] != b) return 1 << i;
    }
    return 0;
  };
  std::vector<std::vector<Index>> loops;
  for (const auto& [t, i] : sides) {
    Index a = complex.triangle(t)[i], b = complex.triangle(t)[(i + 1) % 3], at = t;
    std::vector<Index> walk;
    while (!(seen[at] & bit_of(at, a, b))) {
      seen[at] |= bit_of(at, a, b);
      walk.push_back(a);
      Index next;
      at = walk_fan(complex, kept, b, at, a, next);
      a = b;
      b = next;
    }
    if (!walk.empty()) split_simple(walk, loops);
  }
  return loops;
}

}  // namespace rimline::exact
