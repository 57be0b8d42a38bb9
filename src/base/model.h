// SPDX-License-Identifier: GPL-3.0-or-later
// Every coefficient of the default method. Each has a comment "UNIT: meaning. [SOURCE]", where SOURCE is
//   fitted    by `tools/fit TERM`, and on what it was fitted last;
//   hand      chosen by hand: on what, and what was tried (most trials before version 0.2 were not recorded);
//   derived   follows from a law or from another coefficient.
// A length without a unit is in spacings (mean distance to the six nearest neighbours). "sets" are the older
// point sets of known boundary, "shapes" samples of the analytic shapes. No tuned number stands anywhere else
// in the default method: tests/contract/literals_test.cpp lists the number literals of its rooms.
#pragma once

#include <cstddef>

#include "base/model_search.h"

namespace rimline::model {

// count: neighbours that tell a tangent plane or a spacing. [hand; trials not recorded]
inline constexpr int few_neighbours = 12;
// count: neighbours whose triangles, or offsets, tell what is usual about a point. [hand; trials not
// recorded]
inline constexpr int more_neighbours = 16;

// ---- How a surface was sampled: src/local ----

// count: neighbours whose quadric tells the noise. [hand; trials not recorded]
inline constexpr int noise_neighbours = 12;
// 1: residual below which a quarter of normal noise lies. [derived: root of the chi-square quantile over 7]
inline constexpr double noise_quartile = 0.8;
// 1: residual below which a twentieth of it lies. [derived: the same]
inline constexpr double noise_twentieth = 0.556;
// ratio: twentieth over quartile, as noise has it, from which on relief is no longer what is left over.
// [hand: relief of coarse sets of the corpus]
inline constexpr double relief_ends = 0.8;
// ratio: the same, from which on all of it is noise. [hand: the same]
inline constexpr double noise_everywhere = 0.9;
// 1: variation of the nearest distances up to which points keep apart. [hand: where points keep apart it is
// 0.25, noise and all]
inline constexpr double variation_even = 0.25;
// 1: variation from which on points lie as close as noise has them. [hand: noisy and merged sets of the
// corpus]
inline constexpr double variation_noisy = 0.28;
// 1: variation from which on points are random. [hand: random points have 0.4]
inline constexpr double variation_random = 0.3;
// spacings: noise up to this is left alone. [hand: the quadrics leave as much on clean scans]
inline constexpr double noise_least = 0.07;
// spacings: noise that is taken off in full. [hand: shapes of noise 0.2 must have it in full]
inline constexpr double noise_full = 0.09;
// spacings: noise from which on anisotropy is asked for. [hand; trials not recorded]
inline constexpr double noise_asked = 0.02;
// count: neighbours that tell the surface under noise. [hand; trials not recorded]
inline constexpr int denoise_neighbours = 24;
// rank from 0: the neighbour whose distance is held against the spacing. [hand: 1,000 points of the shapes]
inline constexpr int irregular_near = 11;
// rank from 0: the neighbour that one is held against. [hand: the fortieth, the last of the default lists]
inline constexpr int irregular_far = 39;
// 1: spacing over the distance of the twelfth where points keep apart. [derived: 0.55 on lattices of
// triangles]
inline constexpr double crowding_even = 0.55;
// 1: the same where points are random. [hand: their median is 0.506]
inline constexpr double crowding_random = 0.535;
// 1: spread of counts over that of random points, up to which they are not random. [hand: scan lines have
// 0.74]
inline constexpr double counts_even = 0.75;
// 1: the same from which on they are. [hand: random points have 0.88 and more in samples of 1,000]
inline constexpr double counts_random = 0.85;
// 1: irregularity from which on rims look jagged by chance. [hand; trials not recorded]
inline constexpr double is_random = 0.5;
// spacings squared: nearer offsets are chance to the scatter of a neighbourhood. [hand; trials not recorded]
inline constexpr double anisotropy_core = 0.15;
// log ratio: mean anisotropy up to which it is chance or a mesh's strips. [hand: random points have 0.7 at
// most, a mesh 0.87, scan lines 1.1 or more]
inline constexpr double anisotropy_least = 1;
// ratio: middle over largest eigenvalue below which neighbours are a line and more of them are asked. [hand:
// rows far apart, as scan lines have them]
inline constexpr double frame_line = 0.1;
// 1: frame thickness of a neighbourhood that is no patch: a fold, or two sheets. [hand: camelhead's ears;
// trials not recorded]
inline constexpr double frame_folded = 0.15;
// squared sine: neighbours steeper than this (60 degrees) are on another sheet. [hand; trials not recorded]
inline constexpr double star_steepest = 0.75;

// ---- Triangles that may be the surface: src/surface ----

// spacings: largest circumradius of a proposed triangle; the search takes away what is too much. [hand;
// trials not recorded]
inline constexpr double proposed_largest = 4;
// radians: corners at a vertex that may overlap. [hand; trials not recorded]
inline constexpr double corner_overlap = 0.1;
// cosine: triangles at an edge that meet at less than 60 degrees fold back. [hand; trials not recorded]
inline constexpr double folds_back = 0.5;
// spacings: largest circumradius of an ear that is filled after the first searches. [hand; trials not
// recorded]
inline constexpr double refilled_largest = 1;
// count: triangles of a surface; smaller scraps are none. [hand; trials not recorded]
inline constexpr std::size_t surface_least = 10;
// 1: how far all views of a range image agree on the step. [hand: on other samplings a tenth agree at most]
inline constexpr double range_step_tolerance = 0.02;
// share: samples that agree on it. [hand: on other samplings a tenth agree at most]
inline constexpr double range_step_share = 0.95;
// times the median: area and circumradius of a triangle of a cell. [hand; trials not recorded]
inline constexpr double range_cell_largest = 1.5;
// steps: an edge longer than this is a depth jump. [derived: seen at less than 10 degrees]
inline constexpr double range_jump = 6;
// share of the area: how far triangles are half a cell. [hand: tunnels sampled in rows, which are no scans]
inline constexpr double range_cell_tolerance = 0.15;
// share: triangles that must be half a cell. [hand: the same]
inline constexpr double range_cell_share = 0.8;
// share: triangles at depth jumps that a scan has at least. [hand: scans have 1 to 3 %]
inline constexpr double range_fewest_jumps = 0.005;
// share: triangles well below half a cell that a scan has at most. [hand: scans have none between the samples
// of the raster]
inline constexpr double range_most_slight = 0.0005;
// sine: neighbours of a sample nearer to the line of its row are of the row. [hand: 30 degrees]
inline constexpr double range_in_line = 0.5;
// 1: spread of steps below which gaps between rows and more samples are looked at. [hand: other samplings
// have 0.2 and more]
inline constexpr double range_nearly = 0.18;
// count: points of a range image. [hand; trials not recorded]
inline constexpr int range_fewest_points = 200;

// ---- What rims show: src/evidence ----

// spacings: empty balls are not looked for beyond. [hand; trials not recorded]
inline constexpr double ball_largest = 5;
// count: corners to each side that tell how jagged a rim is. [hand: sets and shapes; mean turning of 65
// corners is up to 0.2 where even]
inline constexpr std::size_t jagged_reach = 32;
// radians: mean turning up to which a rim is even. [hand: up to 0.2 where samples end on the boundary]
inline constexpr double jagged_none = 0.15;
// radians: mean turning from which on it is jagged. [hand: 0.25 to 0.65 where a finer surface was cut]
inline constexpr double jagged_full = 0.35;
// radians: what one corner counts for at most. [hand: a spike is one corner]
inline constexpr double jagged_most = 1.5;
// count: points of a rim that tells. [hand; trials not recorded]
inline constexpr std::size_t jagged_least_rim = 48;
// count: points of a rim that tells a plane. [hand; trials not recorded]
inline constexpr std::size_t cut_least_rim = 48;
// spacings: standard deviation of the heights of the points of a cut. [hand: 45 cuts]
inline constexpr double cut_flat = 1;
// sine: mean of the angle between surface and plane. [hand; trials not recorded]
inline constexpr double cut_upright = 0.5;
// sine: the same at one point. [hand; trials not recorded]
inline constexpr double cut_least_sine = 0.2;
// share: points of a rim that lie outside of where the plane is taken to be. [hand; trials not recorded]
inline constexpr double cut_outermost = 0.05;
// spacings: how deep behind the plane a point may be on the boundary. [hand: to 0.5 0.26 are, from 1 to 2
// 0.03]
inline constexpr double cut_depth = 1;

// ---- From evidence to probability: src/evidence/probability.cpp ----

// log odds of a false ear: at a jagged rim, that the third corner of its triangle is on the boundary.
struct FalseEarModel {
  // log odds: of no evidence. [fitted ears: 38 cuts of 12 models, sets, cropped shapes]
  double constant = -6.69;
  // per radian: the angle at the third corner. [fitted ears]
  double angle = 1.56;
  // per e-fold: rarity of such corners on the surface behind the rim. [fitted ears]
  double log_tail = 0.42;
  // per unit: jaggedness of the rim. [fitted ears]
  double jaggedness = 1.79;
};
inline constexpr FalseEarModel false_ear;

// log odds of a rim to be a boundary and not the end of what could be triangulated.
struct RimModel {
  // log odds: of no evidence. [fitted rims: the corpus]
  double constant = -2.4;
  // per e-fold: points of the rim over usual_points, up to most_points. [fitted rims]
  double size = 0.76;
  // per unit: mean frame thickness along it. [fitted rims]
  double thickness = -4.3;
  // per spacing: median empty ball beyond its edges, up to most_ball. [fitted rims]
  double empty_ball = 3.1;
  // count: points at which size says nothing. [derived: a choice of the constant]
  double usual_points = 12;
  // count: points from which on more say no more. [hand; trials not recorded]
  double most_points = 24;
  // spacings: the same of empty balls. [hand; trials not recorded]
  double most_ball = 3;
};
inline constexpr RimModel rim;

// 1: thickness of the end of a tube of n points around is twice this over n^1.5. [derived: within a tenth
// from 7 to 24 points; halved, since not all openings are as narrow behind]
inline constexpr double opening_thickness = 4;

// log odds of a rim of a range image to be a boundary and not a missing sample.
struct RangeRimModel {
  // log odds: of no evidence. [fitted range_rims: the corpus and sets]
  double constant = -2.784;
  // per e-fold: points of the rim over usual_points, up to most_points. [fitted range_rims]
  double size = 1.034;
  // per unit: how one-sided the neighbours of its points are, mean, 0 to 1. [fitted range_rims]
  double one_sided = 11.914;
  // count: points at which size says nothing. [derived: a choice of the constant]
  double usual_points = 4;
  // count: points from which on more say no more. [hand; trials not recorded]
  double most_points = 24;
};
inline constexpr RangeRimModel range_rim;

// log odds of a point on a rim to be on the boundary.
struct PointOnRimModel {
  // log odds: of no evidence. [fitted points_on: sets and shapes, each weighted by the root of its points]
  double constant = -2.51;
  // per unit: log odds of the ear at the point to be open. [fitted points_on]
  double ear = 0.11;
  // per e-fold: of 1 less the log of chi-square's p. [fitted points_on]
  double chi = 1.36;
  // per unit: log odds of the rim. [fitted points_on]
  double rim = 0.68;
  // log odds: bounds of the ear's. [hand; trials not recorded]
  double least_ear = -4, most_ear = 8;
};
inline constexpr PointOnRimModel point_on_rim;

// log odds of a point right behind a rim's edge.
struct PointBehindRimModel {
  // log odds: of no evidence. [fitted points_behind; then raised by 0.46, so that more of a jagged rim is
  // heeded: on nine cuts held out 0.01 to 0.05 more of the true points have 0.5]
  double constant = -3.7;
  // per unit: log odds of the ear between rim and point to be open. [fitted points_behind]
  double ear = 0.40;
  // per e-fold: of 1 less the log of chi-square's p. [fitted points_behind]
  double chi = 1.94;
  // per unit: log odds of the rim. [fitted points_behind]
  double rim = 0.10;
  // log odds: bounds of the ear's. [hand; trials not recorded]
  double least_ear = -10, most_ear = 4;
};
inline constexpr PointBehindRimModel point_behind_rim;

// probability: of rims, bounds in the log odds of their points. [hand; trials not recorded]
inline constexpr double rim_least = 0.01, rim_most = 0.99;
// probability: of a gap that is none by the least probability asked for, from which on users are told of it.
// [hand: corpus; of 11 gaps from 0.3 to 0.4 three are boundaries, of 149 from 0.1 to 0.3 none]
inline constexpr double doubtful_gap = 0.3;
// count: points of such a gap. [derived: one edge was left out]
inline constexpr int doubtful_least = 4;
// log odds: of a point on a rim of a range image; and per e-fold of 1 less the log of p. [fitted
// range_points: range scans]
inline constexpr double range_point_constant = 0.5, range_point_chi = 0.95;
// probability: of a point right behind one. [hand: 0.06 to 0.12 measured on range scans, whatever the score]
inline constexpr double range_point_behind = 0.12;
// probability: of a sample of a range image in no triangle. [hand; trials not recorded]
inline constexpr float range_point_alone = 0.3F;
// probability: of a point away from all rims. [hand; trials not recorded]
inline constexpr double far_from_rims = 0.001;
// probability: of a point that a triangle joins to a jagged rim. [hand: 107 of 2,912 of known sets]
inline constexpr double behind_jagged = 0.037;
// probability: of a point of a jagged rim that chi-square hardly sees. [hand: 0.77 of 753 points of 45 cuts]
inline constexpr double on_jagged = 0.77;
// probability: of a point at a plane that has cut the surface. [hand: 54 of 396 points of 45 cuts]
inline constexpr double at_cut = 0.14;
// spacings squared: how far off the line a point of a rim is without noise. [hand; trials not recorded]
inline constexpr double blur_sharpest = 0.06;
// 1: the same per squared noise. [hand; trials not recorded]
inline constexpr double blur_noise = 1.6;

// ---- Loops over smooth curves: src/loops/smooth_curve ----

// count: points of a rim that a curve is fitted to, and of a loop over it. [hand; trials not recorded]
inline constexpr std::size_t curve_least = 10;
// spacings: half-width of the fit's window without noise; and more per noise. [hand; trials not recorded]
inline constexpr double curve_window = 4, curve_window_noise = 8;
// count: rounds, each of which fits the curve to the loop of the last. [hand; trials not recorded]
inline constexpr int curve_rounds = 3;
// spacings: middle and half-width of the strip behind the rim that tells the density. [hand; trials not
// recorded]
inline constexpr double strip_middle = 1.5, strip_width = 1;
// spacings: half-width of the valley between rim and surface. [hand; trials not recorded]
inline constexpr double valley_width = 0.12;
// share: by which the expected count is wrong; and on anisotropic points. [hand; trials not recorded]
inline constexpr double valley_share = 0.03, valley_share_anisotropic = 0.08;
// spacings: how far behind random points are as likely on the rim. [derived: half of what a point has to
// itself]
inline constexpr double random_close = 0.5;
// of t: half-width of the window that tells the anisotropy along the curve. [hand; trials not recorded]
inline constexpr double curve_anisotropy_window = 6;
// spacings: from where to where behind the curve it is told. [hand; trials not recorded]
inline constexpr double behind_near = 0.6, behind_far = 2.6;
// log odds: of a point that a path may go through. [hand; trials not recorded]
inline constexpr double path_least_odds = -6;
// 1: variance of the steps of a rim without noise. [hand: steps vary by 0.3 of their length]
inline constexpr double path_uneven = 0.1;
// log odds: about the mean cost of a step, so that it moves no line. [hand; trials not recorded]
inline constexpr double path_usual_step = 0.4;
// times the length before: of a loop that is drawn anew. [derived: triangles cut a third off a small rim]
inline constexpr double smooth_most_length = 1.5;

}  // namespace rimline::model
