// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/column_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "io/lines.h"

namespace rimline::io {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return result;
}

// "X [mm]" -> "x" and "mm".
struct NameAndUnit {
  std::string name, unit;
};

NameAndUnit parted(const std::string& name) {
  const std::size_t open = name.find_first_of("[(");
  const std::size_t close = name.find_first_of("])");
  if (open == std::string::npos || close == std::string::npos || close < open) return {lower(name), {}};
  return {lower(trimmed(std::string_view(name).substr(0, open))), name.substr(open + 1, close - open - 1)};
}

std::optional<std::size_t> find_name(const std::vector<NameAndUnit>& names, std::string_view wanted) {
  const auto found = std::find_if(names.begin(), names.end(), [&](auto& n) { return n.name == wanted; });
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

// The first such character behind the quotes that the line may start with.
std::size_t find_outside_quotes(std::string_view line, char c) {
  const char* first = after_quotes(line.data(), line.data() + line.size());
  return line.find(c, static_cast<std::size_t>(first - line.data()));
}

using Words = std::vector<std::string_view>;

// The three columns that start with one of the words each and end alike: LONGITUDE_LOW goes with
// LATITUDE_LOW.
std::optional<std::array<std::size_t, 3>> find_words(const std::vector<NameAndUnit>& names,
                                                     const std::array<Words, 3>& words) {
  for (const std::string_view first : words[0]) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!names[i].name.starts_with(first)) continue;
      const std::string ending = names[i].name.substr(first.size());
      if (!ending.empty() && std::isalpha(static_cast<unsigned char>(ending.front())) != 0) continue;
      std::array<std::optional<std::size_t>, 3> found = {i, {}, {}};
      for (std::size_t axis = 1; axis < 3; ++axis) {
        for (const std::string_view word : words[axis]) {
          if (!found[axis]) found[axis] = find_name(names, std::string(word) + ending);
        }
      }
      if (found[1] && found[2]) return {{i, *found[1], *found[2]}};
    }
  }
  return std::nullopt;
}

// Names of one stem that end in x, y, z or in three numbers from 0 or 1.
std::optional<std::array<std::size_t, 3>> find_stems(const std::vector<NameAndUnit>& names) {
  for (const auto& letters : {"xyz", "012", "123"}) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string& name = names[i].name;
      if (name.size() < 2 || name.back() != letters[0]) continue;
      if (std::isalnum(static_cast<unsigned char>(name[name.size() - 2])) != 0) continue;
      const std::string stem = name.substr(0, name.size() - 1);
      const auto y = find_name(names, stem + letters[1]), z = find_name(names, stem + letters[2]);
      const bool normals = stem.find("norm") != std::string::npos;
      if (y && z && !normals) return {{i, *y, *z}};
    }
  }
  return std::nullopt;
}

Coordinates chosen(const std::vector<NameAndUnit>& names, std::array<std::size_t, 3> columns) {
  Coordinates result{columns, names[columns[0]].unit, {}};
  for (const std::size_t c : columns) {
    if (names[c].unit != result.unit) result.unit.clear();
  }
  return result;
}

bool are_unit_vectors(const Table& table, std::size_t first) {
  bool any = false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double* v = table.values.data() + row * table.width() + first;
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (length == 0 || std::isnan(length)) continue;  // no normal known here
    if (std::abs(length - 1) > 0.01) return false;
    any = true;
  }
  return any;
}

void name_three(Table& table, std::size_t first) {
  const bool normals = are_unit_vectors(table, first);
  if (!normals && !are_bytes(table, first, 3)) return;
  constexpr const char* names[2][3] = {{"red", "green", "blue"}, {"nx", "ny", "nz"}};
  for (std::size_t i = 0; i < 3; ++i) table.names[first + i] = names[normals ? 1 : 0][i];
}

// Whether the first column numbers the points: ascending integers, nine steps of ten by one. (A surface with
// that as a coordinate would have one point in each plane of it.)
bool first_column_counts(const Table& table) {
  constexpr std::size_t least_rows = 10;
  if (table.width() < 4 || table.rows() < least_rows) return false;
  std::size_t by_one = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double value = table.values[row * table.width()];
    if (value != std::floor(value) || !std::isfinite(value)) return false;
    if (row == 0) continue;
    const double step = value - table.values[(row - 1) * table.width()];
    if (!(step >= 1)) return false;
    by_one += step == 1;
  }
  return 10 * by_one >= 9 * (table.rows() - 1);
}

}  // namespace

std::string column_name(std::string_view cell) {
  std::string name(cell);
  std::erase(name, '"');
  const std::string small = lower(name);
  static constexpr const char* known[] = {"x",   "y",     "z",    "nx",    "ny",       "nz",
                                          "red", "green", "blue", "alpha", "intensity"};
  for (const char* k : known) {
    if (small == k) return k;
  }
  if (small == "r") return "red";
  if (small == "g") return "green";
  if (small == "b") return "blue";
  return name;
}

std::vector<std::string> header_names(std::string_view line) {
  while (!line.empty() && (line.front() == '#' || line.front() == '/' || line.front() == '%'))
    line.remove_prefix(1);
  std::vector<std::string> names;
  std::size_t hard = find_outside_quotes(line, ';');
  if (hard == std::string_view::npos) hard = find_outside_quotes(line, ',');
  if (hard == std::string_view::npos) hard = find_outside_quotes(line, '\t');
  if (hard == std::string_view::npos) {
    for (const auto cell : split(line, {})) names.push_back(column_name(cell));
    return names;
  }
  const char separator = line[hard];
  while (!trimmed(line).empty()) {
    const std::size_t stop = std::min(find_outside_quotes(line, separator), line.size());
    names.push_back(column_name(trimmed(line.substr(0, stop))));
    line.remove_prefix(std::min(stop + 1, line.size()));
  }
  return names;
}

std::optional<Coordinates> find_coordinates(const std::vector<std::string>& names) {
  std::vector<NameAndUnit> parts;
  for (const std::string& name : names) parts.push_back(parted(name));
  const auto x = find_name(parts, "x"), y = find_name(parts, "y"), z = find_name(parts, "z");
  if (x && y && z) return chosen(parts, {*x, *y, *z});
  const Words heights = {"elevation", "height", "altitude", "elev", "alt", "up", "z", "h"};
  if (const auto found = find_words(parts, {{{"easting", "east", "e"}, {"northing", "north", "n"}, heights}}))
    return chosen(parts, *found);
  if (const auto found =
          find_words(parts, {{{"longitude", "long", "lon", "lng"}, {"latitude", "lat"}, heights}})) {
    Coordinates result = chosen(parts, *found);
    result.unit = "degrees and the unit of the height";
    result.warning = fmt::format(
        "x and y are {} and {}, which are angles: project the points to a plane in the unit of "
        "the height before the boundary is trusted",
        names[(*found)[0]], names[(*found)[1]]);
    return result;
  }
  if (const auto found = find_stems(parts)) return chosen(parts, *found);
  return std::nullopt;
}

std::string guess_names(Table& table) {
  const std::size_t width = table.width(), first = first_column_counts(table) ? 1 : 0;
  table.names.assign(1, "id");
  table.names.resize(first);
  table.names.insert(table.names.end(), {"x", "y", "z"});
  for (std::size_t c = first + 3; c < width; ++c) table.names.push_back(fmt::format("column_{}", c + 1));
  const std::size_t own = width - first;  // of the point itself
  if (own == 4) table.names[first + 3] = "intensity";
  if (own == 6 || own == 9) name_three(table, first + 3);
  if (own == 9) name_three(table, first + 6);
  if (own == 7 && are_bytes(table, first + 4, 3)) {
    table.names[first + 3] = "intensity";
    name_three(table, first + 4);
  }
  if (width == 3) return {};
  return fmt::format(
      "the columns have no names and were taken for {}{}; name them in a first line if that is "
      "wrong",
      fmt::join(table.names, " "),
      first == 1 ? fmt::format(", as the first column counts {}, {}, {} ...", table.values[0],
                               table.values[width], table.values[2 * width])
                 : "");
}

}  // namespace rimline::io
