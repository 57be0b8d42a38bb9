// SPDX-License-Identifier: GPL-3.0-or-later
// The decoder of Marc Lehmann's LZF, the compression of PCD files.
#pragma once

#include <cstddef>
#include <string_view>

namespace rimline::io {

// No compressed byte stands for more than this: a copy of 264 bytes takes 3.
inline constexpr std::size_t lzf_most_expansion = 88;

// Fills `to` with exactly `size` bytes; false where the input gives more or fewer, or is damaged.
bool lzf_decompress(std::string_view from, char* to, std::size_t size);

}  // namespace rimline::io
