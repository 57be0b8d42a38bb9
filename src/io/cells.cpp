// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cells.h"

#include <algorithm>
#include <cctype>

#include "io/lines.h"

namespace rimline::io {
namespace {

// Reads a number with a decimal point, or with a decimal comma.
const char* read_decimal(const char* at, const char* end, CellStyle style, double& value) {
  if (!style.decimal_commas) return read_number(at, end, value);
  if (at < end && *at == '+' && at + 1 < end && at[1] != '-' && at[1] != '+') ++at;
  const fast_float::parse_options options(fast_float::chars_format::general, ',');
  const auto result = fast_float::from_chars_advanced(at, end, value, options);
  return result.ec == std::errc::invalid_argument ? nullptr : result.ptr;
}

std::string_view without_quotes(std::string_view cell) {
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return quoted ? cell.substr(1, cell.size() - 2) : cell;
}

// "3,5": digits, one comma, digits.
bool is_decimal_comma(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  if (comma == std::string_view::npos || comma == 0 || comma + 1 == cell.size()) return false;
  return std::all_of(cell.begin() + static_cast<std::ptrdiff_t>(comma) + 1, cell.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; }) &&
         is_number(cell.substr(0, comma), {}) && cell.substr(0, comma).find('.') == std::string_view::npos;
}

// Whether the line writes decimal commas in this style: three cells or more, each an integer or a decimal
// comma, the latter at least twice, or once where semicolons, tabs or quotes part the cells.
bool has_decimal_commas(std::string_view line, CellStyle style) {
  const std::size_t enough = style.in_quotes || line.find_first_of(";\t") != std::string_view::npos ? 1 : 2;
  std::size_t commas = 0;
  const auto cells = split(line, style);
  for (const std::string_view cell : cells) {
    if (is_decimal_comma(cell)) {
      ++commas;
    } else if (!is_number(cell, {}) || cell.find('.') != std::string_view::npos) {
      return false;
    }
  }
  return cells.size() >= 3 && commas >= enough;
}

}  // namespace

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//") || line.starts_with('%');
}

const char* after_quotes(const char* at, const char* end) {
  if (at == end || *at != '"') return at;
  const char* close = std::find(at + 1, end, '"');
  return close == end ? at : close + 1;
}

std::vector<std::string_view> split(std::string_view line, CellStyle style) {
  std::vector<std::string_view> cells;
  const char* end = line.data() + line.size();
  const char* at = skip_blanks(line.data(), end);
  while (at < end) {
    const char* first = at;
    at = after_quotes(at, end);
    while (at < end && !is_blank(*at) && !style.parts(*at)) ++at;
    cells.push_back(without_quotes({first, static_cast<std::size_t>(at - first)}));
    at = skip_blanks(at, end);
    if (at < end && style.parts(*at)) at = skip_blanks(at + 1, end);
  }
  return cells;
}

bool is_number(std::string_view cell, CellStyle style) {
  double value = 0;
  const char* end = cell.data() + cell.size();
  return !cell.empty() && read_decimal(cell.data(), end, style, value) == end;
}

CellStyle style_of(std::string_view text) {
  constexpr int most_lines = 1000;
  Lines lines(text);
  std::string_view line;
  for (int i = 0; i < most_lines && lines.next_filled(line); ++i) {
    line = trimmed(line);
    if (is_comment(line)) continue;
    for (const bool in_quotes : {false, true}) {
      const CellStyle style{.decimal_commas = true, .in_quotes = in_quotes};
      if (has_decimal_commas(line, style)) return style;
    }
    const auto cells = split(line, {});
    const bool points = std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
      return is_number(cell, {}) && cell.find('.') != std::string_view::npos;
    });
    if (points) return {};
  }
  return {};
}

std::vector<std::string_view> split_hard(std::string_view line, CellStyle style) {
  std::vector<std::string_view> cells;
  for (line = trimmed(line); !line.empty();) {
    const char* first = after_quotes(skip_blanks(line.begin(), line.end()), line.end());
    const auto* stop = std::find_if(first, line.end(), [&](char c) { return style.parts(c); });
    const auto length = static_cast<std::size_t>(stop - line.begin());
    cells.push_back(without_quotes(trimmed(line.substr(0, length))));
    line.remove_prefix(std::min(length + 1, line.size()));
  }
  return cells;
}

namespace {

// The end of a cell of text: the next separator, or a blank where the line has no other.
const char* skip_text(const char* at, const char* end, CellStyle style) {
  at = after_quotes(at, end);
  const char* hard = std::find_if(at, end, [&](char c) { return style.parts(c); });
  return hard != end ? hard : std::find_if(at, end, is_blank);
}

// Reads one number, in quotes or not; nullptr where there is none.
const char* read_cell(const char* at, const char* end, CellStyle style, double& value) {
  const bool in_quotes = at < end && *at == '"';
  if (style.in_quotes && !in_quotes) style = {};
  const char* after = read_decimal(at + (in_quotes ? 1 : 0), end, style, value);
  if (after == nullptr || !in_quotes) return after;
  return after < end && *after == '"' ? after + 1 : nullptr;
}

}  // namespace

bool read_cells(std::string_view line, const Columns& columns, CellStyle style, std::vector<double>& values) {
  const char* end = line.data() + line.size();
  const char* at = skip_blanks(line.data(), end);
  for (std::size_t i = 0; i < columns.count; ++i) {
    const char* after = nullptr;
    if (!columns.text.empty() && columns.text[i] != 0) {
      after = skip_text(at, end, style);
    } else {
      double value = 0;
      after = read_cell(at, end, style, value);
      if (after == nullptr) return false;
      values.push_back(value);
    }
    at = skip_blanks(after, end);
    if (at == end) return i + 1 == columns.count;
    if (style.parts(*at)) {
      at = skip_blanks(at + 1, end);
    } else if (at == after) {
      return false;
    }
  }
  return at == end;
}

}  // namespace rimline::io
