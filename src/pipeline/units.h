// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds so large or small that products of lengths would overflow or vanish: they are worked on in a unit of
// their own, a power of two, in which they are about one unit wide. The results are the same but for the
// unit.
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

// Nothing for a cloud whose extent is between 2^-32 and 2^32: lengths up to the power of 15 then fit a
// double.
std::optional<Scaled> scaled_to_unit(Points points, const Options& options, const Given& given,
                                     const Run& run);

// From that unit to the input's. Lengths and areas that the numbers can not hold become infinite or 0.
void to_input_unit(const Scaled& scaled, const Options& options, BoundaryResult& result);
void to_input_unit(const Scaled& scaled, const Options& options, ParameterizeResult& result);
void to_input_unit(const Scaled& scaled, const Options& options, ReconstructResult& result);

// What `method`, a function of rimline/pipeline.h, gives for the scaled cloud, in the unit of the input.
template <class Method>
auto run_scaled(const Method& method, const Scaled& scaled, const Options& options, const Run& run) {
  try {
    auto result = method(scaled.points, scaled.options, run, scaled.given);
    to_input_unit(scaled, options, result);
    return result;
  } catch (NoMesh& error) {
    to_input_unit(scaled, options, error.found);
    throw;
  }
}

}  // namespace rimline::pipeline
