// SPDX-License-Identifier: GPL-3.0-or-later
#include "parse.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "rimline/run.h"

namespace rimline::cli {
namespace {

template <class T>
std::optional<T> whole_text(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& flag, const std::string& wants, const std::string& text) {
  throw Error(ErrorCode::BadOption, fmt::format("{} wants {}, not '{}'", flag, wants, text));
}

}  // namespace

std::int64_t parse_whole(const std::string& flag, const std::string& text, std::int64_t least,
                         std::int64_t most) {
  auto value = whole_text<std::int64_t>(text);
  constexpr double exact = 9007199254740992.0;  // 2^53: doubles up to here are exact whole numbers
  if (!value) {
    const auto number = whole_text<double>(text);
    if (number && std::trunc(*number) == *number && std::abs(*number) <= exact) {
      value = static_cast<std::int64_t>(*number);
    }
  }
  if (!value || *value < least || *value > most) {
    refuse(flag, fmt::format("a whole number from {} to {}", least, most), text);
  }
  return *value;
}

std::uint64_t parse_seed(const std::string& flag, const std::string& text) {
  const auto value = whole_text<std::uint64_t>(text);
  if (!value) refuse(flag, "a whole number from 0 to 18446744073709551615", text);
  return *value;
}

std::size_t parse_bytes(const std::string& flag, const std::string& text) {
  constexpr double most = 1e18;
  double unit = 1;
  std::string digits = text;
  if (!text.empty()) {
    switch (text.back()) {
      case 'k':
      case 'K': unit = 1e3; break;
      case 'm':
      case 'M': unit = 1e6; break;
      case 'g':
      case 'G': unit = 1e9; break;
      default: break;
    }
    if (unit > 1) digits.pop_back();
  }
  const auto value = whole_text<double>(digits);
  if (!value || !(*value >= 0) || !(*value * unit <= most)) {
    refuse(flag, "a number of bytes from 0 to 1e18, with K, M or G behind it or not", text);
  }
  return static_cast<std::size_t>(*value * unit);
}

double parse_number(const std::string& flag, const std::string& text, double least, double most) {
  const auto value = whole_text<double>(text);
  // Written so that NaN, which compares false with everything, is refused.
  if (!value || !(*value >= least && *value <= most)) {
    refuse(flag, fmt::format("a number from {} to {}", least, most), text);
  }
  return *value;
}

bool parse_switch(const std::string& flag, const std::string& text) {
  if (text == "on") return true;
  if (text == "off") return false;
  refuse(flag, "'on' or 'off'", text);
}

namespace {

// The numbers between commas; one too few where one is none.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto part = whole_text<double>(text.substr(begin, end - begin));
    if (!part || !std::isfinite(*part)) break;
    parts.push_back(*part);
    begin = end + 1;
  }
  return parts;
}

bool are_three(const std::vector<double>& parts, const std::string& text) {
  return parts.size() == 3 && std::count(text.begin(), text.end(), ',') == 2;
}

}  // namespace

Point parse_direction(const std::string& flag, const std::string& text) {
  const std::vector<double> parts = numbers_in(text);
  if (!are_three(parts, text) || (parts[0] == 0 && parts[1] == 0 && parts[2] == 0)) {
    refuse(flag, "three numbers X,Y,Z that are not all zero, such as 0,0,1", text);
  }
  return {parts[0], parts[1], parts[2]};
}

Point parse_place(const std::string& flag, const std::string& text) {
  const std::vector<double> parts = numbers_in(text);
  if (!are_three(parts, text)) refuse(flag, "three numbers X,Y,Z, such as 0,0,1.5", text);
  return {parts[0], parts[1], parts[2]};
}

std::array<Index, 4> parse_corners(const std::string& flag, const std::string& text) {
  std::vector<Index> ids;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto id = whole_text<Index>(text.substr(begin, end - begin));
    if (!id || *id < 0 || std::find(ids.begin(), ids.end(), *id) != ids.end()) break;
    ids.push_back(*id);
    begin = end + 1;
  }
  if (ids.size() != 4 || std::count(text.begin(), text.end(), ',') != 3) {
    refuse(flag, "the ids of four different points A,B,C,D, such as 0,17,40,63", text);
  }
  return {ids[0], ids[1], ids[2], ids[3]};
}

std::vector<int> parse_classes(const std::string& flag, const std::string& text) {
  constexpr int most = 255;
  std::vector<int> classes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = whole_text<int>(text.substr(begin, end - begin));
    if (!number || *number < 0 || *number > most)
      refuse(flag, "classes from 0 to 255 with commas between, such as 2 or 2,8", text);
    classes.push_back(*number);
    begin = end + 1;
  }
  return classes;
}

std::size_t parse_choice(const std::string& flag, const std::string& text,
                         const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) refuse(flag, fmt::format("one of {}", fmt::join(names, ", ")), text);
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::string> parse_list(const std::string& flag, const std::string& text,
                                    const std::vector<std::string>& names) {
  std::vector<std::string> list;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    list.push_back(names[parse_choice(flag, text.substr(begin, end - begin), names)]);
    begin = end + 1;
  }
  return list;
}

std::string flag_name(const std::string& field_name) {
  std::string flag = "--" + field_name;
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

}  // namespace rimline::cli
