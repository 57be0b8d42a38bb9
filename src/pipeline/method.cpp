// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/method.h"

#include "base/preset_traits.h"

namespace rimline::pipeline {

const Method& method_of(Preset preset) {
  switch (traits(preset).method) {
    case MethodKind::Default: return default_method();
    case MethodKind::Paper: return method_of_the_paper();
  }
  return default_method();
}

}  // namespace rimline::pipeline
