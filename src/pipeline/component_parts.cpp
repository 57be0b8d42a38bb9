// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/component_parts.h"

namespace rimline::pipeline {

std::vector<ComponentPart> component_parts(const MappedMesh& mesh) {
  std::vector<ComponentPart> parts(mesh.components.size());
  std::vector<Index> local(mesh.vertices.size(), none), owner(mesh.vertices.size(), none);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    ComponentPart& part = parts[mesh.triangle_patch[t]];
    part.places.push_back(t);
    Triangle& own = part.triangles.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const Index v = mesh.triangles[t][c];
      if (owner[v] != mesh.triangle_patch[t]) {
        owner[v] = mesh.triangle_patch[t];
        local[v] = static_cast<Index>(part.vertices.size());
        part.vertices.push_back(v);
      }
      own[c] = local[v];
    }
  }
  return parts;
}

}  // namespace rimline::pipeline
