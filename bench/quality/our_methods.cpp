// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <utility>

#include "quality/method.h"
#include "rimline/pipeline.h"

namespace rimline::bench {
namespace {

template <class Result>
void take_probability(const Result& found, Outcome& outcome) {
  if constexpr (requires { found.boundary_probability; }) {
    outcome.probability.assign(found.boundary_probability.begin(), found.boundary_probability.end());
  }
  if constexpr (requires { found.label; }) {
    for (const auto label : found.label) outcome.label.push_back(static_cast<std::uint8_t>(label));
  }
}

void take_boundary(const BoundaryResult& found, Outcome& outcome) {
  outcome.has_loops = true;
  for (const Loop& loop : found.loops) outcome.loops.push_back(loop.points);
  outcome.boundary = points_of(outcome.loops);
  take_probability(found, outcome);
}

Run one_thread() {
  Run run;
  run.threads = 1;
  return run;
}

// A surface that can not be meshed still has loops.
void reconstruct_or_find(const Case& c, const Options& options, Outcome& outcome) {
  try {
    ReconstructResult result = reconstruct(c.points, options, one_thread());
    outcome.mesh = std::move(result.triangles);
    outcome.uv = std::move(result.uv);
    take_boundary(result.boundary, outcome);
  } catch (const Error& error) {
    outcome.mesh_error = error.what();
    take_boundary(find_boundary(c.points, options, one_thread()), outcome);
  }
}

Outcome run_preset(const Case& c, const Options& options, bool want_mesh) {
  Outcome outcome;
  outcome.has_loops = true;
  const auto start = std::chrono::steady_clock::now();
  try {
    if (want_mesh) {
      reconstruct_or_find(c, options, outcome);
    } else {
      take_boundary(find_boundary(c.points, options, one_thread()), outcome);
    }
  } catch (const Error& error) {
    outcome.error = error.what();
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

Method method_of(Preset preset) {
  Method method;
  method.id = name(preset);
  method.title = preset == Preset::Default ? "rimline" : std::string("preset ") + name(preset);
  method.finds_boundary = method.makes_mesh = true;
  method.is_default = preset == Preset::Default;
  method.run = [options = preset_options(preset)](const Case& c, bool want_mesh) {
    return run_preset(c, options, want_mesh);
  };
  return method;
}

}  // namespace

std::vector<Method> our_methods() {
  return {method_of(Preset::Default), method_of(Preset::Paper), method_of(Preset::PaperLog)};
}

}  // namespace rimline::bench
