// SPDX-License-Identifier: GPL-3.0-or-later
// From evidence to probability: logistic regressions, whose coefficients are in base/model.h.
#pragma once

#include <array>
#include <cstddef>

#include "base/model.h"
#include "evidence/corner_histogram.h"
#include "surface/local_size.h"
#include "surface/triangle_set.h"

namespace rimline {

// What the fitness of the rim would lose if the ear at the middle of five points in a row along it were
// filled by a triangle: its log odds to be open. Large where there is no ear.
double ear_log_odds(const TriangleSet& set, const LocalSizes& sizes, const model::FitnessModel& weights,
                    const std::array<Index, 5>& run);  // [layout]

// What tells whether the selected triangle a, behind, b at the edge a, b of a jagged rim is a false ear:
// where a piece is cut out of a surface triangles are missing, and what is put in their place is obtuse.
struct FalseEarMeasures {
  double angle;       // at which the edge is seen from the point behind it, radians
  double log_tail;    // how rare corners as wide in triangles as large are on the surface behind the rims
  double jaggedness;  // of the rim there
};
FalseEarMeasures measure_false_ear(const TriangleSet& set, const LocalSizes& sizes,
                                   const CornerHistogram& corners, const Triangle& ear, double jaggedness);
double false_ear_log_odds(const FalseEarMeasures& measures);

// That a rim is a boundary of the surface and not the end of what could be triangulated: by its number of
// points, the median over its edges of empty_ball_radius(), and the mean thickness of the frames along it.
double loop_probability(std::size_t points, double empty_ball, double thickness);

// How thick frames may be along a rim of a few points that is no crease: about an opening that small a
// surface bends within its neighbourhoods. Half of what the end of a tube has, 8 / n^1.5 with n even points
// around in square rows (within a tenth from 7 to 24), since not all are as narrow behind it.
double thickness_of_opening(std::size_t points);

// How surely a loop is more than the gap between a point and its neighbours at a density border: by its
// vector area over that of a disc whose radius is the largest spacing on it. 1 from one disc on.
double no_gap(double isoperimetric_ratio);

// The same on a raster, which has a rim where a sample is missing or the depth jumps: one missing sample, six
// points, may be a fault of the scanner.
double range_image_loop_probability(std::size_t points);

// That a point is on the boundary: one on a rim (or right behind it), by the log odds of its ear, its
// chi-square score -log p, and the probability of the rim.
double point_probability(double ear, bool on_rim, double chi_square_score, double loop_probability);

// That a point behind an edge of a jagged rim is on the boundary, by false_ear_log_odds(); and one that only
// a triangle joins to a point of the rim.
double jagged_point_probability(double log_odds, double jaggedness, double loop_probability);
double behind_jagged_point(double jaggedness, double loop_probability);

// That a point of a jagged rim is on the boundary, whatever the chi-square test says: it sees the corners of
// a winding rim badly.
double on_jagged_rim(double jaggedness, double loop_probability);

// That a point is on the boundary that lies at a plane that has cut the surface, though no rim goes through
// it.
double at_cut_probability(double jaggedness, double loop_probability);

// That a point is on a boundary that was drawn anew under noise: by how far outside the line that parts the
// points of the loop from those inside it lies, in spacings; `noise` in spacings as well.
double blurred_probability(double depth, double noise, double loop_probability);
// The log odds in it, were the loop certain.
double blurred_log_odds(double depth, double noise);
// The same on a raster, where the search leaves no ears to look at.
double range_image_point_probability(bool on_rim, double chi_square_score, double loop_probability);

// That a sample of a raster that is in no triangle would be on the boundary if it were in one.
float range_image_isolated_probability();

// That a point away from all rims is on the boundary.
double far_from_rims();

}  // namespace rimline
