// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers from a format that declares no types (text, OBJ, OFF) -> Cloud.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/source.h"
#include "rimline/cloud.h"

namespace rimline::io {

struct Table {
  std::vector<std::string> names;  // of the columns; x, y and z among them
  std::vector<double> values;      // row after row

  std::size_t width() const { return names.size(); }
  std::size_t rows() const { return names.empty() ? 0 : values.size() / names.size(); }
};

// All columns are double, but red, green, blue and alpha: uchar where all of them are integers in 0..255 and
// some is above 1 or all are 0 (else they may be fractions of one).
// `coordinates` are the columns of x, y and z.
Cloud cloud_from_table(const Table& table, std::array<std::size_t, 3> coordinates, const Source& source,
                       const Run& run);
// With the columns that are named x, y and z.
Cloud cloud_from_table(const Table& table, const Source& source, const Run& run);

// True where all numbers of the columns [first, first + count) are integers in 0..255.
bool are_bytes(const Table& table, std::size_t first, std::size_t count);

}  // namespace rimline::io
