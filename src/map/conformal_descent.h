// SPDX-License-Identifier: GPL-3.0-or-later
// Descends from a map without flips to the most conformal one near it.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The mean over the surface of (s1 / s2 + s2 / s1) / 2 of the map's singular values: 1 where it is conformal,
// infinite where a triangle is turned over.
double conformal_distortion(Points points, const Triangulation& mesh, const std::vector<UV>& uv);

// 100 for small meshes, 5 for those of 90,000 triangles or more: a map that converges needs far fewer steps,
// and one that does not would take fifty times as long as the other maps of a large mesh.
int most_descent_steps(std::size_t triangles);

struct DescentOptions {
  double isometry = 0;  // weight of the energy that keeps lengths, for which the map must have about the area
                        // of the surface
  int most_steps = 0;   // 0: most_descent_steps()
};

// Releases the outline of a map and descends by Newton's method towards the least conformal distortion
// (conformal_energy.h). The map must be free of flips, and its loops must neither cross nor touch. Both stay
// so: the region outside of the surface is triangulated at each step and may not flip (Jiang, Schaefer,
// Panozzo 2017, "Simplicial complex augmentation framework for bijective maps"). `uv` has one entry per
// point. Returns the number of steps. It is 0 if the map does not meet these conditions, or if no step lowers
// the energy.
// Each step solves a system of the size of the mesh.
int relax_conformally(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                      const DescentOptions& options, std::vector<UV>& uv, const Run& run);

}  // namespace rimline
