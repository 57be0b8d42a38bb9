// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/source.h"

namespace rimline::io {

bool is_gzip(std::string_view bytes);

// The content of a gzip file (RFC 1952), of all its members. At most `gzip_most_expansion` times as large as
// the file and `gzip_spare_bytes` more, and no more than the memory limit. Throws CannotRead where it is
// damaged or larger, OutOfMemory beyond the limit, Cancelled.
Source unpack_gzip(const Source& packed, const Run& run);

inline constexpr std::size_t gzip_most_expansion = 200, gzip_spare_bytes = std::size_t{1} << 26;

}  // namespace rimline::io
