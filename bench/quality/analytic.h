// SPDX-License-Identifier: GPL-3.0-or-later
// The cases with a formula behind them, from rimline::sample.
#pragma once

#include <optional>
#include <vector>

#include "quality/case.h"
#include "rimline/sample.h"

namespace rimline::bench {

// How many of everything.
struct AnalyticPlan {
  std::uint64_t seed = 1;  // every case's own seed is drawn from it and from the case's name
  std::vector<std::size_t> sizes = {1000, 10000};
  std::vector<double> noises = {0, 0.1, 0.2, 0.5};
  int draws = 20;  // seeds a case
};

// The ten open shapes, at every sampling that fits them.
std::vector<CaseName> analytic_cases(const AnalyticPlan& plan);
// Three surfaces that are no disc and one, the pipe, that is an annulus: 5,000 points of blue noise.
std::vector<CaseName> topology_cases(const AnalyticPlan& plan);
// The three that are no disc, likewise, at the plan's noises.
std::vector<CaseName> closed_cases(const AnalyticPlan& plan);

// Whether the name has a shape that the mesh is measured on, as *sound* of docs/quality.md has it.
std::shared_ptr<const TrueSurface> true_surface(const CaseName& name);

// Draws the points. Nothing where the shape is too small for so few points.
std::optional<Case> make_analytic(const CaseName& name);

}  // namespace rimline::bench
