// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <utility>

#include "quality/method.h"
#include "rimline/pipeline.h"

namespace rimline::bench {
namespace {

void take_boundary(BoundaryResult found, Outcome& outcome) {
  outcome.has_loops = true;
  for (const Loop& loop : found.loops) outcome.loops.push_back(loop.points);
  outcome.boundary = points_of(outcome.loops);
  outcome.probability = std::move(found.boundary_probability);
  for (const PointLabel label : found.label) outcome.label.push_back(static_cast<std::uint8_t>(label));
}

Run one_thread() {
  Run run;
  run.threads = 1;
  return run;
}

void take_mesh(ReconstructResult result, Outcome& outcome) {
  for (std::size_t t = 0; !result.uv.empty() && t < result.triangles.size(); ++t) {
    auto& corners = outcome.corner_uv.emplace_back();
    for (int c = 0; c < 3; ++c) corners[c] = corner_uv(result.uv, result.seams, result.triangles, t, c);
  }
  outcome.mesh = std::move(result.triangles);
  outcome.uv = std::move(result.uv);
  take_boundary(std::move(result.boundary), outcome);
}

// Where no triangle can be given there are still loops.
void reconstruct_or_find(const Case& c, const Options& options, Outcome& outcome) {
  try {
    take_mesh(reconstruct(c.points, options, one_thread()), outcome);
  } catch (const NoMesh& error) {
    outcome.mesh_error = error.what();
    take_boundary(error.found, outcome);
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

Method method_of(const char* id, std::string title, const Options& options) {
  Method method;
  method.id = id;
  method.title = std::move(title);
  method.finds_boundary = method.makes_mesh = true;
  method.run = [options](const Case& c, bool want_mesh) { return run_preset(c, options, want_mesh); };
  return method;
}

Method method_of(Preset preset) {
  const bool is_default = preset == Preset::Default;
  Method method = method_of(name(preset), is_default ? "rimline" : std::string("preset ") + name(preset),
                            preset_options(preset));
  method.is_default = is_default;
  return method;
}

// The default method with another search.
Method with_search(RimSearch search) {
  Options options;
  options.boundary_loops.search = search;
  Method method = method_of(name(search), std::string("search ") + name(search), options);
  method.makes_mesh = false;
  return method;
}

}  // namespace

std::vector<Method> our_methods() {
  return {method_of(Preset::Default), method_of(Preset::Paper), method_of(Preset::PaperLog),
          with_search(RimSearch::Greedy), with_search(RimSearch::Climb)};
}

}  // namespace rimline::bench
