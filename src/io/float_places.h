// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates in formats that hold 32 bits.
#pragma once

#include <string>

#include "io/writers.h"

namespace rimline::io {

// Of finite points; empty where there are none.
struct Box {
  Point low{1, 1, 1}, high{0, 0, 0};
  bool empty() const { return low.x > high.x; }
};

Box box_of(Points points);

// What is taken off all coordinates before they are made floats: nothing where floats hold them to a
// millionth of the diagonal of their box, else a round point near its middle.
Point offset_for_floats(const Cloud& cloud);

// Throws CannotWrite where two corners of a triangle that differ become one when `offset` is taken off and
// what is left made floats; `format` is named in the message.
void check_floats(const MeshToWrite& mesh, Point offset, const std::string& format);

}  // namespace rimline::io
