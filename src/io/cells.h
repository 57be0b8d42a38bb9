// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a line of a table: separators and number formats.
#pragma once

#include <string_view>
#include <vector>

namespace rimline::io {

// Blanks part cells always; so do commas and semicolons, but commas not where they are decimal, unless
// numbers with decimal commas stand in quotes ("1,5","2,5",3).
struct CellStyle {
  bool decimal_commas = false;
  bool in_quotes = false;

  bool parts(char c) const { return c == ';' || (c == ',' && (!decimal_commas || in_quotes)); }
};

// Whether a line starts with #, // or %.
bool is_comment(std::string_view line);

// The position after the quotes that begin at `at`, inside of which nothing separates; `at` where there are
// none.
const char* after_quotes(const char* at, const char* end);

// Cells of a line: parted by blanks, or one separator with blanks around it. A separator at the end of the
// line starts no cell. Quotes around a cell are taken off.
std::vector<std::string_view> split(std::string_view line, CellStyle style);

// True where all of the cell is one number.
bool is_number(std::string_view cell, CellStyle style);

// The number format of a table, by the first line that determines it: 1,5;2,5;3,5 has decimal commas, and so
// has 1,5 2,5 3,5. (1,5,2,5,3,5 is ambiguous.)
CellStyle style_of(std::string_view text);

// The cells of a line with commas or semicolons, in which blanks part nothing.
std::vector<std::string_view> split_hard(std::string_view line, CellStyle style);

// The cells of a line that are read: all but text.
struct Columns {
  std::size_t count = 0;        // of a line
  std::vector<char> text = {};  // 1 for each that is left out; empty where none is
};

// Reads the numbers of a line; false where it has not exactly the cells that it should have.
bool read_cells(std::string_view line, const Columns& columns, CellStyle style, std::vector<double>& values);

}  // namespace rimline::io
