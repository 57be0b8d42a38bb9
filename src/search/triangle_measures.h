// SPDX-License-Identifier: GPL-3.0-or-later
// What a triangle shows by itself, and what leaving it out is worth for that.
#pragma once

#include "local/samples.h"
#include "search/fitness_weights.h"
#include "surface/local_size.h"
#include "surface/triangle_set.h"

namespace rimline {

// Where the neighbours of a triangle's corners lie: the mean_direction() at each.
struct TriangleSides {
  double one_sided = 0, least_one_sided = 0;  // the length: mean and least of the corners
  double toward = 0, least_toward = 0;  // its component along the direction to the triangle's centroid: the
                                        // same. Negative where neighbours lie on the other side. [ours]
};

struct TriangleMeasures {
  double log_ratio;  // of its circumradius to what is typical around its corners
  double own;        // of its circumradius to the largest median of the triangles at its corners, e-folds
  double spread;     // of the sizes around it
  double tip;        // its widest angle, radians
  TriangleSides sides;
};

// The sides are 0 where the weights do not ask for them.
TriangleMeasures measure_triangle(const TriangleSet& set, const LocalSizes& sizes, const Samples& samples,
                                  Index triangle, const FitnessWeights& weights);

// Log odds that it is no part of the surface, before what is beside it and what the rim does there.
double log_odds_alone(const TriangleMeasures& measures, const FitnessWeights& weights);

// How far the size of a triangle falls short of standing out against the one across its edge k, which it must
// have: at most 0, where it is more than least_contrast larger than what is there, at least -1. e-folds.
double lack_of_contrast(const TriangleSet& set, const LocalSizes& sizes, Index triangle, int k,
                        const FitnessWeights& weights);

}  // namespace rimline
