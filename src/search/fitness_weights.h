// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficients of a fitness: those of model.h, and those that only the search along rims has.
#pragma once

#include "base/model.h"

namespace rimline {

// As it is made, that of the first searches, which open what is open.
struct FitnessWeights : model::FitnessModel {
  double tip = 0, spread = 0;                                               // of model::RimFitnessModel
  double even_slight = 0, even_moderate = 0, even_sharp = 0;                // the same
  double one_sided = 0, least_one_sided = 0, toward = 0, least_toward = 0;  // the same

  bool asks_sides() const {
    return one_sided != 0 || least_one_sided != 0 || toward != 0 || least_toward != 0;
  }
};

// The weights of the search for ears along the rims. What holes cost stays as in `first`.
inline FitnessWeights weights_along_rims(const FitnessWeights& first) {
  const model::RimFitnessModel& m = model::rim_fitness;
  FitnessWeights w = first;
  w.open = m.open;
  w.size = m.size;
  w.own = m.own;
  w.tip = m.tip;
  w.spread = m.spread;
  w.even = m.even;
  w.slight = m.slight;
  w.moderate = m.moderate;
  w.sharp = m.sharp;
  w.one_sided = m.one_sided;
  w.least_one_sided = m.least_one_sided;
  w.toward = m.toward;
  w.least_toward = m.least_toward;
  w.even_slight = m.even_slight;
  w.even_moderate = m.even_moderate;
  w.even_sharp = m.even_sharp;
  w.contrast = m.contrast;
  w.pinch = m.pinch;
  return w;
}

}  // namespace rimline
