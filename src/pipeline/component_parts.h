// SPDX-License-Identifier: GPL-3.0-or-later
// The components of a mesh, each with vertices of its own.
#pragma once

#include <vector>

#include "pipeline/mapped_mesh.h"

namespace rimline::pipeline {

struct ComponentPart {
  std::vector<Index> places;        // indices of its triangles in the mesh, ascending
  std::vector<Index> vertices;      // of the mesh, in the order in which its triangles name them first
  std::vector<Triangle> triangles;  // by positions in `vertices`
};

// One for each component, as MappedMesh::triangle_patch has them.
std::vector<ComponentPart> component_parts(const MappedMesh& mesh);

}  // namespace rimline::pipeline
