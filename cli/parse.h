// SPDX-License-Identifier: GPL-3.0-or-later
// From the text of a flag to its value. All of them throw Error{BadOption} with one sentence that names the
// flag, what it wants and what it was given.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "rimline/options.h"

namespace rimline::cli {

// Whole numbers may be written 1000000 or 1e6.
std::int64_t parse_whole(const std::string& flag, const std::string& text, std::int64_t least,
                         std::int64_t most);
std::uint64_t parse_seed(const std::string& flag, const std::string& text);
// A number of bytes: 1500000, 1.5M, 12G; K, M and G count in thousands.
std::size_t parse_bytes(const std::string& flag, const std::string& text);
double parse_number(const std::string& flag, const std::string& text, double least, double most);
bool parse_switch(const std::string& flag, const std::string& text);
// Three numbers with commas between them, not all of them zero.
Point parse_direction(const std::string& flag, const std::string& text);

// A place X,Y,Z.
Point parse_place(const std::string& flag, const std::string& text);
// Four ids of points with commas between them, all different.
std::vector<int> parse_classes(const std::string& flag, const std::string& text);
std::array<Index, 4> parse_corners(const std::string& flag, const std::string& text);
// The position of `text` in `names`.
std::size_t parse_choice(const std::string& flag, const std::string& text,
                         const std::vector<std::string>& names);

// Some of `names`, with commas between them.
std::vector<std::string> parse_list(const std::string& flag, const std::string& text,
                                    const std::vector<std::string>& names);

// "length_exponent" -> "--length-exponent".
std::string flag_name(const std::string& field_name);

// The values of an enumeration that counts up from 0, each with its own name. Past the last, name() gives
// "?" or a name that was there before.
template <class Enum>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (int i = 0;; ++i) {
    const std::string next = name(static_cast<Enum>(i));
    if (next == "?" || std::find(names.begin(), names.end(), next) != names.end()) return names;
    names.push_back(next);
  }
}

template <class Enum>
Enum parse_enum(const std::string& flag, const std::string& text) {
  return static_cast<Enum>(parse_choice(flag, text, names_of<Enum>()));
}

// The value of one field of the options.
template <class T>
void parse_field(const Field<T>& field, const std::string& text) {
  const std::string flag = flag_name(field.name);
  if constexpr (std::is_enum_v<T>) {
    field.value = parse_enum<T>(flag, text);
  } else if constexpr (std::same_as<T, bool>) {
    field.value = parse_switch(flag, text);
  } else if constexpr (std::integral<T>) {
    const bool is_word = field.zero[0] != 0 && text == field.zero;
    field.value = is_word ? T{} : static_cast<T>(parse_whole(flag, text, field.least, field.most));
  } else if constexpr (std::floating_point<T>) {
    field.value = parse_number(flag, text, field.least, field.most);
  } else {
    field.value = text;
  }
}

}  // namespace rimline::cli
