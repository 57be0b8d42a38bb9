// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a line of a table: how they are parted and how their numbers are written.
#pragma once

#include <string_view>
#include <vector>

namespace rimline::io {

// Blanks part cells always; so do commas and semicolons, but commas not where they are decimal.
struct CellStyle {
  bool decimal_commas = false;

  bool parts(char c) const { return c == ';' || (c == ',' && !decimal_commas); }
};

bool is_comment(std::string_view line);

// Cells of a line: parted by blanks, or one separator with blanks around it. A separator at the end of the
// line starts no cell. Quotes around a cell are taken off.
std::vector<std::string_view> split(std::string_view line, CellStyle style);

// True where all of the cell is one number.
bool is_number(std::string_view cell, CellStyle style);

// How the lines of a table write numbers, as the first of them that can tell does: 1,5;2,5;3,5 has decimal
// commas, and so has 1,5 2,5 3,5. (In 1,5,2,5,3,5 nothing tells the commas apart.)
CellStyle style_of(std::string_view text);

// Reads the `width` numbers of a line; false where it has not exactly these.
bool read_cells(std::string_view line, std::size_t width, CellStyle style, std::vector<double>& values);

}  // namespace rimline::io
