// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficients of the stage clean, in the form of model.h.
#pragma once

#include <cstddef>

namespace rimline::model {

// ---- Stray points: src/clean ----

// count: points of a set in which some may be stray; fewer tell no surface. [hand; no other tried]
inline constexpr std::size_t stray_fewest_points = 50;
// share: of all points; where more seem stray there is no surface that they could be beside. [hand; no other
// tried]
inline constexpr double stray_most_share = 0.2;
// ratio: of the 95 % to the 5 % quantile of the scale; where it is larger no single point is called stray
// but for sparse groups. [hand: mannequin_devil, 34, loses true points and gets false loops]
inline constexpr double stray_most_graded = 4;
// spacings of the denser end: the widest gap within a group that may be sparse. [hand: 3 finds fewer of 5 %
// of outliers, 85 % in place of 88 % of them on 39 sets; clean sets lose the same]
inline constexpr double sparse_gap = 2;
// ratio: of the spacing of a sparse group to that of the points around it. [hand: 1.6 finds no more]
inline constexpr double sparse_ratio = 2;
// share of the points: the largest sparse group. [derived: outliers are 5 % at most]
inline constexpr double sparse_most = 0.06;
// share: of the neighbours of a sparse point that are so much denser. [hand; no other tried]
inline constexpr double sparse_around = 0.4;
// share: of the points of a coarse part of a surface that lie on it at their own scale. [hand: coarse parts
// of the corpus have 0.90 and more, groups of outliers 0.5 and less]
inline constexpr double sparse_on_surface = 0.6;
// count: neighbours that tell the surface that a point may be off. [hand: 16 follow noise]
inline constexpr int stray_neighbours = 24;
// count: points of a group apart where the scale varies beyond stray_most_graded. [hand: camelhead loses six
// true points in smaller ones, and gets a false loop]
inline constexpr std::size_t apart_fewest_graded = 8;
// count: rounds of the reweighted fits. [hand: as good as ten on the corpus]
inline constexpr int stray_rounds = 5;
// times the median: residual at which a neighbour does not count for a plane, ... [hand; no other tried]
inline constexpr double stray_plane_cut = 6;
// spacings: ... with this added to the median, so that exact planes keep theirs. [hand; no other tried]
inline constexpr double stray_plane_floor = 0.03;
// deviations: the same for a quadric. [derived: 95 % efficiency of the biweight under normal noise]
inline constexpr double stray_cut = 4.7;
// 1: standard deviation over median of absolute values. [derived: normal law]
inline constexpr double median_to_deviation = 1.48;
// spacings: deviation of exact points. [hand; no other tried]
inline constexpr double stray_floor = 0.01;
// share: points whose deviation is usual. [hand: 0.95 finds fewer of 5 % outliers; without it more true
// points are called stray, by a prototype on the corpus]
inline constexpr double stray_usual_share = 0.9;
// deviations: height over the surface from which on a point is off it. [hand: with 4 and 5 more points of the
// corpus are called stray, by a prototype]
inline constexpr double stray_deviations = 6;
// spacings: the least such height. [hand: with 0.4 true points of thin parts are called stray]
inline constexpr double stray_least = 1.2;
// spacings, and deviations: the same where the surface is whole without the point. [hand: fewest points of
// the corpus, by a prototype]
inline constexpr double stray_least_whole = 0.1, stray_deviations_whole = 4;
// spacings: from the foot of such a point to the nearest on the surface, ... [derived: half a spacing and a
// tenth, as far as a place on a surface is from its samples at most]
inline constexpr double stray_redundant = 0.55;
// spacings: the height from which on it is enough that the nearest is so near. [hand: 73 % in place of 69 %
// of 0.5 % outliers within 5 spacings on 39 sets; 174 in place of 161 of 1.65 million clean points]
inline constexpr double stray_high = 0.6, stray_redundant_high = 0.9;
// radians: ... and the widest angle between those around it. [derived: a right angle]
inline constexpr double stray_gap = 1.6;
// spacings: those around it. [hand; no other tried]
inline constexpr double stray_around = 2.5;
// share: of that height, over a plane that is not robust, from which on it is measured. [hand; no
// other tried]
inline constexpr double stray_quick = 0.6;
// spacings: points so near, off the surface too, may be another sheet. [hand; no other tried]
inline constexpr double stray_beside = 1.8;
// count: such points that a stray one has at most. [hand; no other tried]
inline constexpr int stray_most_others = 2;
// spacings, and times the distance of the nearest: what a point on a line sees. [hand: two steps of a line]
inline constexpr double chain_reach = 1.8, chain_reach_nearest = 1.5;
// cosine: of the cone in which it sees it. [hand: 15 degrees; a strip of triangles shows 20 and more]
inline constexpr double chain_cone = 0.966;
// count: points of a chain. [hand: single teeth of rims are none]
inline constexpr std::size_t chain_least = 3;
// of its length: how far its points are off the line from end to end. [hand: dense rims bend more]
inline constexpr double chain_bend = 0.05;
// count: points between chain and surface that go with it. [hand; no other tried]
inline constexpr std::size_t chain_most_root = 2;
// times the mean step: the longest between them. [hand; no other tried]
inline constexpr double chain_uneven = 1.5;
// spacings: what such a point sees, in a cone of this cosine. [hand: 70 degrees; points of a rim see 90]
inline constexpr double chain_root_reach = 1.3, chain_root_cone = 0.342;
// cosine: of the angle to a chain from which on others are beside it, ... [derived: 45 degrees]
inline constexpr double chain_side = 0.707;
// spacings: ... as near as this. [hand; no other tried]
inline constexpr double chain_beside = 2.5;
// share: chains of more points than this are how the surface was sampled. [hand; no other tried]
inline constexpr double chain_most_share = 0.2;
// of the distance to the nearest, and spacings: points of that spacing are as lonely as one that seems stray.
// [hand: mannequin_devil, whose density varies 34-fold]
inline constexpr double graded_share = 0.6, graded_least = 1.6;
// count: of the 12 nearest, from which on density varies there. [hand: the same; single outliers are 5 % at
// most]
inline constexpr int graded_count = 5;
// spacings: a point as far from the nearest as this is looked at again at its own scale, in which the
// distance to the nearest is 1. [hand; no other tried]
inline constexpr double own_coarser = 1.3;
// of that scale: the radius around the point, and the least distance between two. [hand; no other tried]
inline constexpr double own_radius = 3.2, own_apart = 0.6;
// of that scale: its height over their surface, if it is part of it. [hand: single points of mannequin_devil]
inline constexpr double own_height = 0.35;
// radians: the widest angle between them. [derived: less than at a rim]
inline constexpr double own_gap = 2.6;
// of that scale: the spacing of one that is alike, and its distance. [hand; no other tried]
inline constexpr double own_alike = 0.6, own_alike_near = 2.2;
// spacings: the widest gap within a group. [hand: gaps of the corpus]
inline constexpr double apart_gap = 3;
// count: points next to one that tell whether it is alone, ... [hand; no other tried]
inline constexpr int apart_asked = 6;
// times the largest spacing there: ... by its distance to the nearest. [hand: fewest points of the corpus
// beside 1.8 and 1.6, by a prototype]
inline constexpr double apart_alone = 2.5;
// share of the points, and count: a group of more is a part of the surface. [hand: the least part of the
// corpus]
inline constexpr double apart_share = 0.02, apart_most = 50;

// ---- Coordinates in steps: src/clean/steps ----

// spacings: values nearer than this are one level, whose width is at most that. [hand; no other tried]
inline constexpr double step_least = 0.05;
// share: of the points that are on levels, if the coordinate is in steps. [hand: 5 % may be outliers]
inline constexpr double step_share = 0.9;
// count: points of a level on average. [hand; no other tried]
inline constexpr double step_points = 8;
// spacings: steps from this on part the surface; shorter ones are noise that is removed as such. [hand:
// sampled shapes keep their loops up to 1, not from 2 on]
inline constexpr double terrace_least = 1.2;
// spacings: longer ones part surfaces. [hand: a depth camera's wall has 3.2; a plate before a wall 12]
inline constexpr double terrace_longest = 6;
// count: levels of a surface in terraces; fewer are plates. [hand; no other tried]
inline constexpr std::size_t terrace_levels = 3;
// ratio: of the spacing when steps are squeezed to that before; where it is less, levels lie over each other,
// as layers do. [hand: 0.95 on a depth camera's wall, 0.7 where two layers coincide]
inline constexpr double terrace_beside = 0.85;
// spacings: the length of a step while neighbours across it are looked for. [hand: 0.3 to 1 alike]
inline constexpr double terrace_squeezed = 0.4;
// cosine: of the angle of the normal to the steps, from which on points are moved. [derived: 60 degrees]
inline constexpr double terrace_across = 0.5;
// count: rounds of the smoothing. [hand: 20 to 50 alike]
inline constexpr int terrace_rounds = 30;
// steps: a neighbour that far along is another surface; how far a point is moved at most. [hand: with 1 and
// half a step the wall of a depth camera keeps false holes, since its depths scatter by a step]
inline constexpr double terrace_near = 2, terrace_most = 1;

}  // namespace rimline::model
