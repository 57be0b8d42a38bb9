// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured: a way from points to a boundary, a mesh, or both.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "quality/case.h"
#include "quality/loop_score.h"

namespace rimline::bench {

struct Outcome {
  std::string error;       // why there is no answer; empty where there is one
  std::string mesh_error;  // why there is no mesh though one was wanted
  bool has_loops = false;
  LoopIds loops;
  std::vector<Index> boundary;  // ids of the boundary points, each once, where there are no loops
  std::vector<Triangle> mesh;
  std::vector<UV> uv;                        // per point, NaN where it has none or several
  std::vector<std::array<UV, 3>> corner_uv;  // per triangle, or empty
  std::vector<float> probability;            // per point, or empty
  std::vector<std::uint8_t> label;           // per point, or empty
  double seconds = 0;
};

struct Method {
  std::string id;     // as --methods takes it
  std::string title;  // as the tables show it
  bool finds_boundary = false, makes_mesh = false;
  bool is_default = false;  // gets all seeds of the plan; others fewer
  std::function<Outcome(const Case&, bool want_mesh)> run;
};

// The library's default and presets, and "greedy": the default without its search.
std::vector<Method> our_methods();
// The closed loops among the arcs that local evidence gives.
Method arcs_method();
// Those whose program was built.
std::vector<Method> peer_methods();

}  // namespace rimline::bench
