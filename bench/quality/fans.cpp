// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/fans.h"

#include <algorithm>

#include "quality/edge_set.h"

namespace rimline::bench {
namespace {

struct Corner {
  Index at, next, last;  // the vertex, and the edge opposite to it

  friend auto operator<=>(const Corner&, const Corner&) = default;
};

}  // namespace

std::size_t count_nonmanifold_vertices(const std::vector<Triangle>& mesh) {
  std::vector<Corner> corners;
  corners.reserve(3 * mesh.size());
  for (const Triangle& t : mesh) {
    for (int i = 0; i < 3; ++i) corners.push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
  }
  std::sort(corners.begin(), corners.end());
  // The same walk over few edges for each vertex: pieces are counted by relabelling, stars are small.
  std::size_t count = 0;
  for (std::size_t first = 0; first < corners.size();) {
    std::size_t last = first;
    while (last < corners.size() && corners[last].at == corners[first].at) ++last;
    std::vector<Index> ids;
    for (std::size_t i = first; i < last; ++i) ids.insert(ids.end(), {corners[i].next, corners[i].last});
    std::vector<Index> label = ids;
    std::sort(label.begin(), label.end());
    label.erase(std::unique(label.begin(), label.end()), label.end());
    const std::vector<Index> link = label;
    const auto place = [&](Index id) {
      return std::lower_bound(link.begin(), link.end(), id) - link.begin();
    };
    std::size_t pieces = link.size();
    for (std::size_t i = 0; i < ids.size(); i += 2) {
      const Index a = label[place(ids[i])], b = label[place(ids[i + 1])];
      if (a == b) continue;
      std::replace(label.begin(), label.end(), b, a);
      --pieces;
    }
    count += pieces > 1;
    first = last;
  }
  return count;
}

}  // namespace rimline::bench
