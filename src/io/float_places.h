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
  void add(Point p);  // where it is finite
};

// Of the corners of the triangles; of all points where there are no triangles. A point far from the mesh is
// none of its business.
Box box_of_corners(const MeshToWrite& mesh);

// Whether floats can hold a point; what they make of one that they can.
bool floats_hold(Point p);
Point as_floats(Point p);

// What is taken off all coordinates before they are made floats: nothing where floats hold the corners to a
// millionth of the diagonal of their box, else a round point near its middle.
Point offset_for_floats(const MeshToWrite& mesh);

// Throws CannotWrite where two corners of a triangle that differ become one when `offset` is taken off and
// what is left made floats; `what` is named in the message.
void check_floats(const MeshToWrite& mesh, Point offset, const std::string& what);

}  // namespace rimline::io
