// SPDX-License-Identifier: GPL-3.0-or-later
// Scales clouds so large or small that products of lengths would overflow or underflow. They are processed in
// a unit that is a power of two, in which they are about one unit wide. The results are the same except for
// the unit.
#pragma once

#include <optional>
#include <vector>

#include "rimline/pipeline.h"

namespace rimline::pipeline {

// The input in that unit.
struct Scaled {
  int exponent;  // one unit is 2^exponent units of the input
  std::vector<Point> points;
  Options options;
  Given given;
};

// None for a cloud whose extent is between 2^-32 and 2^32: lengths up to the power of 15 then fit a double.
std::optional<Scaled> scaled_to_unit(Points points, const Options& options, const Given& given,
                                     const Run& run);

// Translates results back to the input's unit. Lengths and areas out of range become infinite or 0.
BoundaryResult in_input_unit(BoundaryResult result, const Scaled& scaled, const Options& options);
ParameterizeResult in_input_unit(ParameterizeResult result, const Scaled& scaled, const Options& options);
ReconstructResult in_input_unit(ReconstructResult result, const Scaled& scaled, const Options& options);

// Calls `method`, a function of rimline/pipeline.h, on the scaled cloud, and returns its result in the unit
// of the input.
template <class Method>
auto run_scaled(const Method& method, const Scaled& scaled, const Options& options, const Run& run) {
  try {
    return in_input_unit(method(scaled.points, scaled.options, run, scaled.given), scaled, options);
  } catch (NoMesh& error) {
    error.found = in_input_unit(std::move(error.found), scaled, options);
    throw;
  }
}

}  // namespace rimline::pipeline
