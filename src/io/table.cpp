// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "io/fields.h"

namespace rimline::io {
namespace {

bool is_colour(const std::string& name) {
  return name == "red" || name == "green" || name == "blue" || name == "alpha";
}

bool colours_are_bytes(const Table& table) {
  double largest = 0;
  for (std::size_t c = 0; c < table.width(); ++c) {
    if (!is_colour(table.names[c])) continue;
    if (!are_bytes(table, c, 1)) return false;
    for (std::size_t i = c; i < table.values.size(); i += table.width())
      largest = std::max(largest, table.values[i]);
  }
  return largest != 1;
}

template <class T>
Column take_column(const Table& table, std::size_t column) {
  std::vector<T> values(table.rows());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<T>(table.values[i * table.width() + column]);
  }
  return make_column(table.names[column], values);
}

}  // namespace

bool are_bytes(const Table& table, std::size_t first, std::size_t count) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t c = first; c < first + count; ++c) {
      const double value = table.values[row * table.width() + c];
      if (!(value >= 0 && value <= 255 && value == std::floor(value))) return false;
    }
  }
  return true;
}

Cloud cloud_from_table(const Table& table, std::array<std::size_t, 3> coordinates, const Source& source,
                       const Run& run) {
  const auto [x, y, z] = coordinates;
  const std::size_t width = table.width();
  check_point_count(source, table.rows());
  Cloud cloud;
  cloud.points.resize(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (i % items_per_look == 0) run.check_cancel();
    const double* row = table.values.data() + i * width;
    cloud.points[i] = {row[x], row[y], row[z]};
  }
  const bool bytes = colours_are_bytes(table);
  for (std::size_t c = 0; c < width; ++c) {
    if (c == x || c == y || c == z) continue;
    cloud.columns.push_back(bytes && is_colour(table.names[c]) ? take_column<std::uint8_t>(table, c)
                                                               : take_column<double>(table, c));
  }
  make_names_usable(cloud.columns);
  return cloud;
}

Cloud cloud_from_table(const Table& table, const Source& source, const Run& run) {
  const auto column_of = [&](const char* name) {
    return static_cast<std::size_t>(std::find(table.names.begin(), table.names.end(), name) -
                                    table.names.begin());
  };
  return cloud_from_table(table, {column_of("x"), column_of("y"), column_of("z")}, source, run);
}

}  // namespace rimline::io
