// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the presets. This is the one switch over them: it has no `default`, so that the compiler
// reports a preset that is missing.
#pragma once

#include "rimline/options.h"

namespace rimline {

// The algorithms that find the loops and mesh the surface.
enum class MethodKind { Default, Paper };

struct PresetTraits {
  const char* name = "?";
  MethodKind method = MethodKind::Default;
  ScoreForm score_form = ScoreForm::Log;
  int least_neighbours = 0;  // neighbours of each point that the method needs whatever the options are
};

constexpr PresetTraits traits(Preset preset) {
  constexpr int of_spacing = 6;  // for local_spacing()
  constexpr int of_noise = 40;   // for the sampling profile
  switch (preset) {
    case Preset::Default: return {"default", MethodKind::Default, ScoreForm::Log, of_noise};
    case Preset::Paper: return {"paper", MethodKind::Paper, ScoreForm::Capped, of_spacing};
    case Preset::PaperLog: return {"paper-log", MethodKind::Paper, ScoreForm::Log, of_spacing};
  }
  return {};  // no value of the enumeration
}

}  // namespace rimline
