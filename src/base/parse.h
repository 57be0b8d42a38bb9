// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in text.
#pragma once

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace rimline {

// Reads one number, exactly rounded; a sign + and nan, inf, infinity in any case are accepted. Returns the
// place after it, or nullptr where there is none.
template <class T>
const char* read_number(const char* at, const char* end, T& value) {
  if (at < end && *at == '+') {
    ++at;
    if (at < end && (*at == '-' || *at == '+')) return nullptr;
  }
  if (at >= end) return nullptr;
  if constexpr (std::is_floating_point_v<T>) {
    const auto result = fast_float::from_chars(at, end, value);
    // Too large is infinite and too small is zero: the value that fits best.
    return result.ec == std::errc::invalid_argument ? nullptr : result.ptr;
  } else {
    const auto result = std::from_chars(at, end, value);
    const bool whole =
        result.ec == std::errc() &&
        (result.ptr == end || (*result.ptr != '.' && *result.ptr != 'e' && *result.ptr != 'E'));
    if (whole) return result.ptr;
    double real = 0;  // "255.0" where an integer was announced
    const char* after = read_number(at, end, real);
    if (after == nullptr || real != std::floor(real)) return nullptr;
    // The bounds are exact powers of two, or one below; 2^digits excludes what rounds up.
    const double limit = std::ldexp(1.0, std::numeric_limits<T>::digits);
    if (!(real >= static_cast<double>(std::numeric_limits<T>::min()) && real < limit)) return nullptr;
    value = static_cast<T>(real);
    return after;
  }
}

}  // namespace rimline
