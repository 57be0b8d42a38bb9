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

// The fitness that the rim would lose if the ear at the middle of five consecutive points were filled by a
// triangle: the log odds that it is open. Large where there is no ear.
double ear_log_odds(const TriangleSet& set, const LocalSizes& sizes, const model::FitnessModel& weights,
                    const std::array<Index, 5>& run);  // [layout]

// Features that tell whether the selected triangle a, behind, b at the edge a, b of a jagged rim is a false
// ear: where a piece was cut out of a surface triangles are missing, and what is put in their place is
// obtuse.
struct FalseEarMeasures {
  double angle;       // angle of the edge at the point behind it, radians
  double log_tail;    // rarity of such corners of triangles as large on the surface behind the rims
  double jaggedness;  // of the rim there
};
FalseEarMeasures measure_false_ear(const TriangleSet& set, const LocalSizes& sizes,
                                   const CornerHistogram& corners, const Triangle& ear, double jaggedness);
double false_ear_log_odds(const FalseEarMeasures& measures);

// Probability that a rim is a boundary of the surface and not just the end of the triangulation: by its
// number of points, the median over its edges of empty_ball_radius(), and the mean thickness of the frames
// along it.
double loop_probability(std::size_t points, double empty_ball, double thickness);

// Thickness of the frames along a rim of a few points that is no crease: around an opening that small a
// surface bends within its neighbourhoods. Half of the value at the end of a tube, 8 / n^1.5 with n even
// points around in square rows (within a tenth from 7 to 24), since not all openings are as narrow behind.
double thickness_of_opening(std::size_t points);

// Certainty that a loop is more than the gap between a point and its neighbours at a density border: its
// vector area over that of a disc whose radius is the largest spacing on it; 1 from one disc on.
double no_gap(double isoperimetric_ratio);

// The same for a range image, which has a rim where a sample is missing or the depth jumps: by the number of
// its points and the mean length of their mean_direction(), which is small around one missing sample.
double range_image_loop_probability(std::size_t points, double one_sided);

// Probability of a point on a rim, or right behind it, to be on the boundary, by the log odds of its ear, its
// chi-square score -log p, and the probability of the rim.
double point_probability(double ear, bool on_rim, double chi_square_score, double loop_probability);

// Probability of a point behind an edge of a jagged rim, by false_ear_log_odds(); and of one that only a
// triangle joins to a point of the rim.
double jagged_point_probability(double log_odds, double jaggedness, double loop_probability);
double behind_jagged_point(double jaggedness, double loop_probability);

// Probability of a point of a jagged rim, whatever the chi-square test says: the test is poor at the corners
// of a winding rim.
double on_jagged_rim(double jaggedness, double loop_probability);

// Probability of a point at a plane that has cut the surface, though no rim passes through it.
double at_cut_probability(double jaggedness, double loop_probability);

// Probability of a point near a boundary that was redrawn under noise: by its distance, in spacings, outside
// the line that separates the points of the loop from those inside it; `noise` in spacings as well.
double blurred_probability(double depth, double noise, double loop_probability);
// Its log odds for a certain loop.
double blurred_log_odds(double depth, double noise);
// The same for a range image, where the search leaves no ears to consider.
double range_image_point_probability(bool on_rim, double chi_square_score, double loop_probability);

// Probability of a sample of a range image in no triangle to be on the boundary.
float range_image_isolated_probability();

// Probability of a point away from all rims to be on the boundary.
double far_from_rims();

}  // namespace rimline
