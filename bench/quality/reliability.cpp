// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/reliability.h"

#include <algorithm>
#include <cmath>

namespace rimline::bench {

void Reliability::add(double probability, bool is_boundary) {
  const int slice = std::clamp(static_cast<int>(probability * 10), 0, 9);
  bins[slice].points += 1;
  bins[slice].boundary += is_boundary;
  bins[slice].probability += probability;
  squared_error += (probability - is_boundary) * (probability - is_boundary);
}

void Reliability::add(const Reliability& other) {
  for (std::size_t i = 0; i < bins.size(); ++i) {
    bins[i].points += other.bins[i].points;
    bins[i].boundary += other.bins[i].boundary;
    bins[i].probability += other.bins[i].probability;
  }
  squared_error += other.squared_error;
}

double Reliability::points() const {
  double sum = 0;
  for (const Bin& bin : bins) sum += bin.points;
  return sum;
}

double Reliability::boundary() const {
  double sum = 0;
  for (const Bin& bin : bins) sum += bin.boundary;
  return sum;
}

double Reliability::brier() const { return points() > 0 ? squared_error / points() : 0; }

double Reliability::constant_brier() const {
  const double share = points() > 0 ? boundary() / points() : 0;
  return share * (1 - share);
}

double Reliability::gain() const { return constant_brier() > 0 ? 1 - brier() / constant_brier() : 0; }

Reliability measure_reliability(std::span<const float> probability, std::span<const std::uint8_t> boundary) {
  Reliability result;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    if (std::isnan(probability[i]) || boundary[i] > 1) continue;
    result.add(probability[i], boundary[i] == 1);
  }
  return result;
}

Metrics score_probability(std::span<const float> probability, std::span<const std::uint8_t> boundary) {
  double truth = 0, half = 0, low = 0;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    if (boundary[i] != 1) continue;
    truth += 1;
    half += probability[i] >= 0.5f;
    low += probability[i] < 0.1f;
  }
  if (truth == 0) return {};
  return {{"boundary_probability_half", half / truth}, {"boundary_probability_low", low / truth}};
}

}  // namespace rimline::bench
