// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/close_gap.h"

#include "mesh/close_ring.h"

namespace rimline {

bool close_gap(EditableMesh& mesh, const std::vector<Index>& rim) {
  constexpr std::size_t largest = 200;  // points: an eighth of a second
  if (rim.size() > largest) return false;
  const std::vector<Index> ring(rim.rbegin(), rim.rend());  // the gap on its left
  const std::vector<Triangle> filling =
      close_ring(mesh.points(), ring, [&](Index a, Index b) { return mesh.count_at(a, b) > 0; });
  if (filling.empty() || (filling.size() == 1 && !mesh.can_add(filling[0]))) return false;
  for (const Triangle& t : filling) mesh.add(t);
  return true;
}

}  // namespace rimline
