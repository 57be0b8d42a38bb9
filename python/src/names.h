// SPDX-License-Identifier: GPL-3.0-or-later
// Enumerations of the library by the names that it gives their values.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "rimline/run.h"

namespace rimline::python {

// The values of an enumeration that counts up from 0, each with its own name. Past the last, name() gives
// "?" or a name that was there before.
template <class Enum>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (int i = 0;; ++i) {
    const std::string next = name(static_cast<Enum>(i));
    if (next == "?" || std::ranges::find(names, next) != names.end()) return names;
    names.push_back(next);
  }
}

// The value of that name. Throws BadOption with the names that there are.
template <class Enum>
Enum value_of(const std::string& what, const std::string& text) {
  const std::vector<std::string> names = names_of<Enum>();
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) {
    throw Error(ErrorCode::BadOption,
                fmt::format("{} is '{}'; it must be one of {}", what, text, fmt::join(names, ", ")));
  }
  return static_cast<Enum>(found - names.begin());
}

}  // namespace rimline::python
