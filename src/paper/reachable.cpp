// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/reachable.h"

namespace rimline {
namespace {

// The reversed lists: for each point the points that have it in their list.
struct ReverseLists {
  std::vector<std::size_t> first;
  std::vector<Index> ids;

  ReverseLists(const Neighbours& neighbours, int k) : first(neighbours.size() + 1, 0) {
    for (Index i = 0; i < neighbours.size(); ++i) {
      for (const Index j : neighbours.of(i, k)) ++first[j + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    ids.resize(first.back());
    std::vector<std::size_t> at(first.begin(), first.end() - 1);
    for (Index i = 0; i < neighbours.size(); ++i) {
      for (const Index j : neighbours.of(i, k)) ids[at[j]++] = i;
    }
  }
};

}  // namespace

std::vector<Index> unreachable_points(const Neighbours& neighbours, int k, std::span<const Index> loop) {
  const ReverseLists reverse(neighbours, k);
  std::vector<char> reached(neighbours.size(), 0);
  std::vector<Index> open(loop.begin(), loop.end());
  for (const Index id : loop) reached[id] = 1;
  while (!open.empty()) {
    const Index at = open.back();
    open.pop_back();
    for (std::size_t j = reverse.first[at]; j < reverse.first[at + 1]; ++j) {
      const Index id = reverse.ids[j];
      if (reached[id]) continue;
      reached[id] = 1;
      open.push_back(id);
    }
  }
  std::vector<Index> unreachable;
  for (Index i = 0; i < neighbours.size(); ++i) {
    if (!reached[i]) unreachable.push_back(i);
  }
  return unreachable;
}

}  // namespace rimline
