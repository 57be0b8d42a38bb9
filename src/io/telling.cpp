// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/telling.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "io/lines.h"
#include "io/readers.h"

namespace rimline::io {
namespace {

constexpr std::size_t looked_at = 4096;  // bytes

std::string_view start_of(std::string_view bytes) { return bytes.substr(0, looked_at); }

// The first line that is neither blank nor a comment, within what is looked at.
std::string_view first_line(std::string_view bytes) {
  Lines lines(start_of(bytes));
  std::string_view line;
  return lines.next_filled(line, '#') ? line : std::string_view{};
}

std::string_view first_word(std::string_view bytes) { return Row(first_line(bytes)).word(); }

}  // namespace

std::string lower_ending(std::string_view name) {
  const std::size_t dot = name.find_last_of("./");
  if (dot == std::string_view::npos || name[dot] == '/') return {};
  std::string ending(name.substr(dot + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

bool is_text(std::string_view bytes) {
  const std::string_view start = start_of(bytes);
  return std::none_of(start.begin(), start.end(), [](unsigned char c) {
    return c < 32 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
}

bool is_utf16(std::string_view bytes) {
  constexpr std::size_t looked_at_here = 32;
  if (bytes.size() < looked_at_here) return false;
  const auto zeros = [&](std::size_t from) {
    std::size_t count = 0;
    for (std::size_t i = from; i < looked_at_here; i += 2) count += bytes[i] == '\0';
    return count;
  };
  constexpr std::size_t all = looked_at_here / 2;
  return (zeros(0) == all && zeros(1) == 0) || (zeros(1) == all && zeros(0) == 0);
}

bool tells_ply(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r"); }

bool tells_pcd(std::string_view bytes) {
  const std::string_view word = first_word(bytes);
  return bytes.starts_with("# .PCD") || word == "VERSION" || word == "FIELDS" || word == "COLUMNS";
}

bool tells_stl(std::string_view bytes) {
  if (bytes.size() > 84 && is_stl_binary(bytes)) return true;  // may start with "solid" too
  return is_text(bytes) && first_word(bytes) == "solid";
}

bool tells_off(std::string_view bytes) {
  const std::string_view word = first_word(bytes);
  return word.size() <= 8 && word.ends_with("OFF");
}

bool tells_obj(std::string_view bytes) {
  constexpr std::array<std::string_view, 12> keywords = {"v", "vn", "vt", "vp",     "f",      "l",
                                                         "p", "o",  "g",  "mtllib", "usemtl", "s"};
  if (!is_text(bytes)) return false;
  Row row(first_line(bytes));
  const std::string_view keyword = row.word();
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end() && !row.done();
}

}  // namespace rimline::io
