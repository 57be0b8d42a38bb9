// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of the columns of a table, by its header or by its content.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/cells.h"
#include "io/table.h"

namespace rimline::io {

// Known names (x, nx, red, intensity, ...) in the spelling of PLY, whatever their case; all others as they
// are.
std::string column_name(std::string_view cell);

// The names of a header line; a leading comment mark is no part of it. Between commas or semicolons, where
// the line has any, names may have blanks.
std::vector<std::string> header_names(std::string_view line);

// Which columns are the coordinates.
struct Coordinates {
  std::array<std::size_t, 3> columns{};
  std::string unit = {};     // "mm", where the header says it of all three
  std::string warning = {};  // a remark on the choice for the user; may be empty
};

// By their names: x y z; X [mm]; easting northing elevation; longitude latitude elevation; names that differ
// in their last letter or number alone (POINT_X POINT_Y POINT_Z; Points:0 Points:1 Points:2). Nothing where
// no three columns are so named.
std::optional<Coordinates> find_coordinates(const std::vector<std::string>& names);

// Names columns without a header by what is common: x y z; x y z intensity; x y z r g b; x y z nx ny nz;
// x y z intensity r g b (PTS); both triples in any order; any of these after a first column that counts the
// points, which becomes `id`. Returns a sentence that says how they were guessed; empty for x y z alone.
std::string guess_names(Table& table);

}  // namespace rimline::io
