// SPDX-License-Identifier: GPL-3.0-or-later
// What an object tells of itself in a line: its __repr__.
#pragma once

#include <fmt/format.h>

#include <string>

namespace rimline::python {

// "1,984 points", "1 loop".
inline std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", fmt::group_digits(count), noun, count == 1 ? "" : "s");
}

template <class... Parts>
std::string story(const char* type, const Parts&... parts) {
  std::string told = fmt::format("<rimline.{}:", type);
  const char* before = " ";
  for (const std::string& part : {std::string(parts)...}) {
    told += before + part;
    before = ", ";
  }
  return told + ">";
}

}  // namespace rimline::python
