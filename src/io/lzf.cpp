// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/lzf.h"

#include <cstring>

namespace rimline::io {

// A control byte below 32 starts a run of control + 1 literal bytes. Any other holds a length in its upper
// three bits (7: one more byte is added to it) and, with the byte after that, a distance of 13 bits: length +
// 2 bytes are copied from distance + 1 before the end of the output; the two ranges may overlap.
bool lzf_decompress(std::string_view from, char* to, std::size_t size) {
  std::size_t in = 0, out = 0;
  const auto byte = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(from[at]));
  };
  while (in < from.size()) {
    const std::size_t control = byte(in++);
    if (control < 32) {
      const std::size_t length = control + 1;
      if (from.size() - in < length || size - out < length) return false;
      std::memcpy(to + out, from.data() + in, length);
      in += length;
      out += length;
      continue;
    }
    std::size_t length = control >> 5;
    if (from.size() - in < (length == 7 ? 2u : 1u)) return false;
    if (length == 7) length += byte(in++);
    length += 2;
    const std::size_t distance = ((control & 31) << 8) + byte(in++) + 1;
    if (distance > out || size - out < length) return false;
    for (std::size_t i = 0; i < length; ++i, ++out) to[out] = to[out - distance];
  }
  return out == size;
}

}  // namespace rimline::io
