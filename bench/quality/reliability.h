// SPDX-License-Identifier: GPL-3.0-or-later
// Are probabilities true? Of the points given 0.9 to 1, about 95 % should be boundary.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "quality/metrics.h"

namespace rimline::bench {

struct Reliability {
  struct Bin {
    double points = 0;       // with a probability in [0.1 i, 0.1 (i + 1)), the last one with 1
    double boundary = 0;     // of them, on the true boundary
    double probability = 0;  // sum over them
  };
  std::array<Bin, 10> bins;
  double squared_error = 0;  // sum of (probability - truth)^2

  void add(double probability, bool boundary);
  void add(const Reliability& other);

  double points() const;
  double boundary() const;
  double brier() const;           // mean squared error
  double constant_brier() const;  // of the best constant, the share of boundary points
  double gain() const;  // 1 - brier / constant_brier: 1 is perfect, 0 is no better than the constant
};

// Over the points with flag 0 or 1 and a probability that is a number.
Reliability measure_reliability(std::span<const float> probability, std::span<const std::uint8_t> boundary);

// boundary_probability_half, boundary_probability_low: the share of the true boundary points with 0.5 or
// more, and with less than 0.1. Points without a probability (strays) have neither.
Metrics score_probability(std::span<const float> probability, std::span<const std::uint8_t> boundary);

}  // namespace rimline::bench
