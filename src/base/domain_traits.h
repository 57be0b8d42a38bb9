// SPDX-License-Identifier: GPL-3.0-or-later
// What sets the domains apart. This is the one switch over them: it has no `default`, so that the compiler
// names it where a domain is added.
#pragma once

#include "rimline/options.h"

namespace rimline {

// Where the outer loop is held while the inside is mapped.
enum class Outline {
  None,    // nowhere: there is no map
  Circle,  // the unit circle
  Box,     // four corners and the sides between them, the first on the axis u
};

struct DomainTraits {
  const char* name = "?";
  Outline outline = Outline::None;
  bool square = false;    // of a box: as high as wide; else its height follows from the lengths of the sides
  bool released = false;  // the outline is let go of afterwards: the map has the scale of the surface

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
