// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/method.h"

namespace rimline::pipeline {

const Method& method_of(Preset preset) {
  return preset == Preset::Default ? default_method() : method_of_the_paper();
}

}  // namespace rimline::pipeline
