// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficients of the search; model.h, which includes them, says how they are written.
#pragma once

#include <cstddef>

namespace rimline::model {

// ---- What a selection is worth: src/search ----

// radians: turning that counts as slight; the next piece of the piecewise linear cost. [hand; trials not
// recorded]
inline constexpr double turn_slight = 0.3, turn_moderate = 0.7;
// log ratio: bounds of how far a triangle exceeds the largest median at its corners. [hand; trials not
// recorded]
inline constexpr double own_least = -1, own_most = 3;

// log odds. Started from a logistic regression on the ears of known boundaries, then tuned by hand on what
// the search finds on sets and shapes of 1,000 points. Fitted anew they tell no more (wrong triangles 0.15,
// then 0.14), and a search with them wears even rims away.
struct FitnessModel {
  // log odds: for each triangle left out ... [hand: sets and shapes]
  double open = 1.4;
  // per e-fold: ... and for its log ratio ... [hand: the same]
  double size = 0.7;
  // per e-fold: ... and for its ratio to the largest median around its corners. [hand: the same]
  double own = 2.4;
  // log odds: less for one that all corners have on rims known to be even. [hand: sets]
  double even = 1;
  // per radian: of turning up to turn_slight, [hand: sets and shapes]
  double slight = 7.4;
  // per radian: correction up to turn_moderate, [hand: the same]
  double moderate = -3.0;
  // per radian: and of all turning: a smooth rim is precious, a jagged one is not. [hand: the same]
  double sharp = 1.5;
  // per e-fold: that the ratio of the sizes on both sides of the rim ... [hand: the same]
  double contrast = 7;
  // e-folds: ... falls short of this. [hand: the same]
  double least_contrast = 0.4;
  // log odds: cost where fans meet in a point. [hand: the same]
  double pinch = 2;
  // log odds: cost of a hole apart from all other rims ... [hand: loop counts on shapes]
  double hole_prior = 3;
  // per unit: ... and of the spread of sizes around it ... [hand: loop counts on random shapes]
  double hole_prior_spread = 15;
  // per e-fold: ... and of the points beyond 1,000: chance has more places. [derived: the number of places]
  double hole_prior_points = 1;
  // log odds: in place of all three where the spread does not bring about such a hole. [hand: corpus]
  double hole_prior_beyond_spread = 1;
  // log odds: the prior of a hole where noise alone spreads the sizes. [hand; trials not recorded]
  double hole_prior_noise = 1;
  // log odds: cost of a point that loses all its triangles. [hand: sets and shapes]
  double isolated = 12;
};

// log odds. The same for the search for ears along the rims that the others have found: what leaving one
// triangle out is worth, all others as truth has them (pseudo-likelihood, Besag 1975).
struct RimFitnessModel {
  // log odds: for each triangle left out ... [fitted triangles: the corpus]
  double open = -7.736;
  // per e-fold: ... for its log ratio, [fitted triangles]
  double size = -3.868;
  // per e-fold: for its ratio to the largest median around its corners, [fitted triangles]
  double own = 1.874;
  // per radian: for its widest angle, [fitted triangles]
  double tip = 4.518;
  // per unit: for the spread of the sizes around it, [fitted triangles]
  double spread = -3.218;
  // per unit: for how one-sided the neighbours of its corners are, 0 to 1, mean and least; [fitted triangles]
  double one_sided = 2.987, least_one_sided = 5.871;
  // per unit: for how far they lie towards it, -1 to 1, mean and least. [fitted triangles]
  double toward = -12.240, least_toward = 2.099;
  // log odds: and less for one that all corners have on rims known to be even. [fitted triangles]
  double even = -1.610;
  // per radian: of turning up to turn_slight, up to turn_moderate, and of all; [fitted triangles]
  double slight = 4.001, moderate = -0.094, sharp = -0.042;
  // per radian: more at a vertex on an even rim. [fitted triangles]
  double even_slight = -3.647, even_moderate = 4.185, even_sharp = 0.922;
  // per e-fold: that the ratio of the sizes on both sides falls short of least_contrast. [fitted triangles]
  double contrast = 3.004;
  // log odds: cost where fans meet in a point. [fitted triangles]
  double pinch = 0.821;
};
inline constexpr RimFitnessModel rim_fitness;
// points: nearest ones of a corner that tell on which side of it neighbours are. [hand: of 12, 16, 24 and 40
// the one with the least log loss of triangles]
inline constexpr int side_neighbours = 24;

// log ratio: least size of a triangle at a rim that is a candidate. [hand; trials not recorded]
inline constexpr double candidate_least = 0.1;
// log odds: of a triangle by itself, from which on it is a candidate of the search for ears whatever its
// size. [derived: as likely as not]
inline constexpr double candidate_least_odds = 0;
// count: triangles of a change along a rim that is taken over; a longer one may be a worn row. [hand: corpus;
// with 3 leaf_natural loses 0.15 of its points F1, without a bound mannequin loses its last row]
inline constexpr std::size_t ear_most = 2;
// log odds: by which an ear must be likelier out than in. [hand: corpus, loops exact 0.504 with 0, 0.499 with
// 1, 0.467 with 2; points F1 of mannequin 0.981 with 0, 1.000 with 1]
inline constexpr double ear_margin = 1;
// log ratio beyond the spread: of a triangle that lets a hole start inside. [hand; trials not recorded]
inline constexpr double candidate_inside = 0.35;
// log ratio beyond the spread: of a triangle that closes an opening, whatever the gaps beside it are. [hand:
// small openings of shapes: loop count right in 97.6 %, with it in 100 %]
inline constexpr double candidate_plain = 0.8;
// triangles: how deep from the rim candidates are. [hand; trials not recorded]
inline constexpr int candidate_deepest = 12;
// count: points of a gap that is told from a boundary. [hand; trials not recorded]
inline constexpr std::size_t gap_least = 6;
// probability: a rim below this is a gap whose triangles are left alone. [hand: corpus; with 0.5 the outline
// of isis_front runs out into a gap beside it, with 0.7 three sets of the corpus lose]
inline constexpr double gap_most = 0.62;
// log ratio: the choice by size alone. [hand; trials not recorded]
inline constexpr double greedy_size = 0.8;
// log ratio: thresholds of the first population, from the first down by the range. [hand; trials not
// recorded]
inline constexpr double population_first = 1.6, population_range = 1.5;
// log ratio: a threshold that keeps all. [derived: above the largest log ratio]
inline constexpr double population_all = 10;
// times: empty disc of a hole over the usual one. [hand: noise 0.5: loop count right 85 %, with it 95 %]
inline constexpr double hole_least_size = 2;
// 1: standard deviation over the quartiles' range as spreads have it. [derived: normal law, typical above
// median]
inline constexpr double spread_to_deviation = 0.75;
// log ratio: what a usual triangle has, since typical is above the median. [hand: corpus]
inline constexpr double spread_usual = 0.1;
// e-folds: a hole of which chance would have e^-4 has no part in it. [hand: corpus]
inline constexpr double spread_margin = 4;
// 1: area times density of a typical empty circle of random points. [derived: Gamma(2), 5/8 up]
inline constexpr double chance_typical = 2.15;
// e-folds: the same margin where the density is not known well. [hand: 700 samples of shapes without noise]
inline constexpr double chance_margin = 8;
// count: points that priors of holes are told for. [derived: shapes of 1,000 points]
inline constexpr double prior_points = 1000;
// count: layers of false ears that are removed. [hand: a third gives 0.939 and 0.901 on cuts, no more]
inline constexpr int false_ear_layers = 2;

}  // namespace rimline::model
