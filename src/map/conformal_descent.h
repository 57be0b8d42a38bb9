// SPDX-License-Identifier: GPL-3.0-or-later
// From a map without turned triangles to the most conformal one near it.
#pragma once

#include <vector>

#include "mesh/triangulation.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The mean over the surface of (s1 / s2 + s2 / s1) / 2 of the map's singular values: 1 where it is conformal,
// infinite where a triangle is turned over.
double conformal_distortion(Points points, const Triangulation& mesh, const std::vector<UV>& uv);

// Lets go the outline of a map that turns no triangle over and whose loops neither cross nor touch, and
// descends towards the least conformal distortion (conformal_energy.h) by Newton's method. On the way no
// triangle turns, and the loops stay as clear of each other and of themselves: what lies outside of the
// surface is triangulated at each step and must not turn either (Jiang, Schaefer, Panozzo 2017, "Simplicial
// complex augmentation framework for bijective maps"). `uv` has one entry per point. Returns how many steps
// were made; 0 where it was such a map not, or none was found.
int relax_conformally(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                      std::vector<UV>& uv, const Run& run);

}  // namespace rimline
