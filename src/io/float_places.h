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

// Adds the corners of the triangles; without triangles all points. Points far from the mesh must not count.
Box box_of_corners(const MeshToWrite& mesh);

// Whether floats can hold a point, and the rounded point.
bool floats_hold(Point p);
Point as_floats(Point p);

// The offset subtracted from all coordinates before they become floats: zero where floats hold the corners to
// a millionth of the diagonal of their box, else a round point near its middle.
Point offset_for_floats(const MeshToWrite& mesh);

// Throws CannotWrite where two corners of a triangle that differ become one when `offset` is taken off and
// what is left made floats; `what` is named in the message.
void check_floats(const MeshToWrite& mesh, Point offset, const std::string& what);

}  // namespace rimline::io
