// SPDX-License-Identifier: GPL-3.0-or-later
// XYZ, TXT, CSV, PTS: a point a line. The first line with numbers sets the number of columns; every other
// line must have as many.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "io/fields.h"
#include "io/lines.h"
#include "io/readers.h"
#include "io/table.h"

namespace rimline::io {
namespace {

bool is_hard_separator(char c) { return c == ',' || c == ';'; }

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with("//"); }

// Cells between separators: blanks, or one comma or semicolon with blanks around it. A separator at the end
// of the line does not start a cell.
std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  const char* at = line.data();
  const char* end = at + line.size();
  at = skip_blanks(at, end);
  while (at < end) {
    const char* first = at;
    while (at < end && !is_blank(*at) && !is_hard_separator(*at)) ++at;
    cells.emplace_back(first, static_cast<std::size_t>(at - first));
    at = skip_blanks(at, end);
    if (at < end && is_hard_separator(*at)) at = skip_blanks(at + 1, end);
  }
  return cells;
}

bool is_number(std::string_view cell) {
  double value = 0;
  return read_number(cell.data(), cell.data() + cell.size(), value) == cell.data() + cell.size() &&
         !cell.empty();
}

// "3,5": digits, one comma, digits.
bool is_decimal_comma(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  if (comma == std::string_view::npos || comma == 0 || comma + 1 == cell.size()) return false;
  return std::all_of(cell.begin() + static_cast<std::ptrdiff_t>(comma) + 1, cell.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; }) &&
         is_number(cell.substr(0, comma)) && cell.substr(0, comma).find('.') == std::string_view::npos;
}

// Three cells or more, parted by blanks or semicolons, each an integer or a decimal comma, the latter at
// least twice: 1,5;2,5;3,5. (In 1,5,2,5,3,5 nothing tells the commas apart.)
bool has_decimal_commas(std::string_view line) {
  int cells = 0, commas = 0;
  for (const char *at = line.data(), *end = at + line.size(); at < end;) {
    const char* first = at;
    while (at < end && !is_blank(*at) && *at != ';') ++at;
    const std::string_view cell(first, static_cast<std::size_t>(at - first));
    while (at < end && (is_blank(*at) || *at == ';')) ++at;
    if (cell.empty()) continue;
    ++cells;
    if (is_decimal_comma(cell)) {
      ++commas;
    } else if (!is_number(cell) || cell.find('.') != std::string_view::npos) {
      return false;
    }
  }
  return cells >= 3 && commas >= 2;
}

[[noreturn]] void fail_row(std::string_view line, std::size_t width, const Source& source) {
  if (has_decimal_commas(line)) {
    source.fail_at_line(line.data(), "numbers with decimal commas; write decimal points (1.5, not 1,5)");
  }
  const auto cells = split(line);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty()) {
      source.fail_at_line(line.data(), "value " + std::to_string(i + 1) +
                                           " is empty; fill it (nan is allowed) " + "or remove the line");
    }
    if (!is_number(cells[i])) {
      source.fail_at_line(line.data(),
                          quoted(cells[i]) + " is not a number; correct it, or put # before a comment");
    }
  }
  source.fail_at_line(line.data(), "has " + std::to_string(cells.size()) +
                                       " values where the lines before have " + std::to_string(width) +
                                       "; complete or remove the line");
}

// Reads the `width` numbers of a line; false where it has not exactly these.
bool read_row(std::string_view line, std::size_t width, std::vector<double>& values) {
  const char* at = line.data();
  const char* end = at + line.size();
  at = skip_blanks(at, end);
  for (std::size_t i = 0; i < width; ++i) {
    double value = 0;
    const char* after = read_number(at, end, value);
    if (after == nullptr) return false;
    values.push_back(value);
    at = skip_blanks(after, end);
    if (at == end) return i + 1 == width;
    if (is_hard_separator(*at)) {
      at = skip_blanks(at + 1, end);
    } else if (at == after) {
      return false;
    }
  }
  return at == end;
}

// Known names in the spelling of PLY, whatever their case; all others as they are.
std::string column_name(std::string_view cell) {
  std::string name(cell);
  std::erase(name, '"');
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  static constexpr const char* known[] = {"x",   "y",     "z",    "nx",    "ny",       "nz",
                                          "red", "green", "blue", "alpha", "intensity"};
  for (const char* k : known) {
    if (lower == k) return k;
  }
  if (lower == "r") return "red";
  if (lower == "g") return "green";
  if (lower == "b") return "blue";
  return name;
}

// Header cells: between commas or semicolons where the line has any (names may have blanks then).
std::vector<std::string> header_names(std::string_view line) {
  while (!line.empty() && (line.front() == '#' || line.front() == '/')) line.remove_prefix(1);
  std::vector<std::string> names;
  const std::size_t hard = line.find_first_of(",;");
  if (hard == std::string_view::npos) {
    for (const auto cell : split(line)) names.push_back(column_name(cell));
    return names;
  }
  const char separator = line[hard];
  while (!trimmed(line).empty()) {
    const std::size_t stop = std::min(line.find(separator), line.size());
    names.push_back(column_name(trimmed(line.substr(0, stop))));
    line.remove_prefix(std::min(stop + 1, line.size()));
  }
  return names;
}

bool names_coordinates(const std::vector<std::string>& names) {
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return has("x") && has("y") && has("z");
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

// Names for columns without a header, by what is common: x y z, x y z intensity, x y z r g b, x y z nx ny nz,
// x y z intensity r g b (PTS), and both triples in any order.
void guess_names(Table& table) {
  const std::size_t width = table.width();
  table.names = {"x", "y", "z"};
  for (std::size_t c = 3; c < width; ++c) table.names.push_back(fmt::format("column_{}", c + 1));
  if (width == 4) table.names[3] = "intensity";
  if (width == 6 || width == 9) name_three(table, 3);
  if (width == 9) name_three(table, 6);
  if (width == 7 && are_bytes(table, 4, 3)) {
    table.names[3] = "intensity";
    name_three(table, 4);
  }
}

// What stands above the numbers, and what they are.
class TextReader {
 public:
  TextReader(const Source& source, const Run& run) : source_(source), run_(run), lines_(text(source)) {}

  Cloud read() {
    std::string_view line;
    for (std::size_t number = 0; lines_.next(line); ++number) {
      if (number % items_per_look == 0) source_.progress(run_, lines_.at());
      const char* first = skip_blanks(line.data(), line.data() + line.size());
      line.remove_prefix(static_cast<std::size_t>(first - line.data()));
      if (line.empty()) continue;
      if (is_comment(line)) {
        if (table_.names.empty()) last_comment_ = line;
        continue;
      }
      if (table_.names.empty() && !start_table(line)) continue;
      if (!read_row(line, table_.width(), table_.values)) fail_row(line, table_.width(), source_);
    }
    if (table_.names.empty()) source_.fail("has no points: no line of numbers");
    check_count();
    if (!named_) guess_names(table_);
    return cloud_from_table(table_, source_, run_);
  }

 private:
  static std::string_view text(const Source& source) {
    std::string_view bytes = source.bytes();
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);  // the byte order mark of UTF-8
    return bytes;
  }

  // True on the first row of numbers; before it come a header and, in PTS files, the number of points.
  bool start_table(std::string_view line) {
    const auto cells = split(line);
    const bool numbers = std::all_of(cells.begin(), cells.end(), is_number);
    if (has_decimal_commas(line)) fail_row(line, 0, source_);
    if (!numbers) {
      if (!header_.empty()) fail_row(line, 0, source_);
      header_ = header_names(line);
      header_line_ = line;
      return false;
    }
    std::uint64_t count = 0;
    const char* end = cells[0].data() + cells[0].size();
    if (cells.size() == 1 && !count_ && read_number(cells[0].data(), end, count) == end) {
      count_ = count;
      return false;
    }
    if (cells.size() < 3) {
      source_.fail_at_line(
          line.data(), "has " + std::to_string(cells.size()) + " values; a point needs at least x, y and z");
    }
    name_columns(cells.size(), line);
    const std::size_t rows =
        lines_.at() == source_.begin() ? 1 : source_.bytes().size() / (line.size() + 1) + 1;
    table_.values.reserve(rows * cells.size());
    return true;
  }

  void name_columns(std::size_t width, std::string_view line) {
    if (!header_.empty() && !names_coordinates(header_)) {
      source_.fail_at_line(header_line_.data(), quoted(header_line_) +
                                                    " is neither numbers nor column names with " +
                                                    "x, y and z; name the columns, or put # before the line");
    }
    if (!header_.empty() && header_.size() != width) {
      source_.fail_at_line(line.data(), "has " + std::to_string(width) + " values where the header names " +
                                            std::to_string(header_.size()) + " columns");
    }
    // "//X Y Z R G B" and "# x y z intensity" are common too.
    if (header_.empty() && !last_comment_.empty()) {
      auto names = header_names(last_comment_);
      if (names.size() == width && names_coordinates(names)) header_ = std::move(names);
    }
    named_ = !header_.empty();
    table_.names = named_ ? header_ : std::vector<std::string>(width);
  }

  void check_count() const {
    if (!count_ || *count_ == table_.rows()) return;
    source_.fail("its first number announces " + std::to_string(*count_) + " points, but " +
                 std::to_string(table_.rows()) + " follow; the file is truncated, or remove that line");
  }

  const Source& source_;
  const Run& run_;
  Lines lines_;
  std::string_view last_comment_, header_line_;
  std::vector<std::string> header_;
  std::optional<std::uint64_t> count_;
  bool named_ = false;
  Table table_;
};

}  // namespace

Cloud read_text(const Source& source, const Run& run) { return TextReader(source, run).read(); }

}  // namespace rimline::io
