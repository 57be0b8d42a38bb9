// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the domains. This is the one switch over them: it has no `default`, so that the compiler
// reports a domain that is missing.
#pragma once

#include "rimline/options.h"

namespace rimline {

// The outline on which the outer loop is fixed while the interior is mapped.
enum class Outline {
  None,    // none: there is no map
  Circle,  // the unit circle
  Box,     // four corners and the sides between them, the first on the axis u
};

struct DomainTraits {
  const char* name = "?";
  Outline outline = Outline::None;
  bool square = false;    // for a box: as high as wide; else its height follows from the lengths of the sides
  bool released = false;  // the outline is released after the first map: the map has the scale of the surface

  constexpr bool is_mapped() const { return outline != Outline::None; }
};

constexpr DomainTraits traits(Domain domain) {
  switch (domain) {
    case Domain::Disc: return {.name = "disc", .outline = Outline::Circle};
    case Domain::Square: return {.name = "square", .outline = Outline::Box, .square = true};
    case Domain::Rectangle: return {.name = "rectangle", .outline = Outline::Box};
    case Domain::Free: return {.name = "free", .outline = Outline::Circle, .released = true};
    case Domain::None: return {.name = "none"};
  }
  return {};  // no value of the enumeration
}

}  // namespace rimline
