// SPDX-License-Identifier: GPL-3.0-or-later
// What sets the presets apart. This is the one switch over them: it has no `default`, so that the compiler
// names it where a preset is added.
#pragma once

#include "rimline/options.h"

namespace rimline {

// How the loops are found and the surface is meshed.
enum class MethodKind { Default, Paper };

struct PresetTraits {
  const char* name = "?";
  MethodKind method = MethodKind::Default;
  ScoreForm score_form = ScoreForm::Log;
  int least_neighbours = 0;  // of each point that the method measures with, whatever the options say
};

constexpr PresetTraits traits(Preset preset) {
  constexpr int of_spacing = 6;  // neighbours of local_spacing()
  constexpr int of_noise = 40;   // and of the default method's measures of the sampling
  switch (preset) {
    case Preset::Default: return {"default", MethodKind::Default, ScoreForm::Log, of_noise};
    case Preset::Paper: return {"paper", MethodKind::Paper, ScoreForm::Capped, of_spacing};
    case Preset::PaperLog: return {"paper-log", MethodKind::Paper, ScoreForm::Log, of_spacing};
  }
  return {};  // no value of the enumeration
}

}  // namespace rimline
