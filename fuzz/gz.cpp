// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a gzip file: unpacked within its bound, and read, or refused.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/gzip.h"
#include "io/readers.h"
#include "whole.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rimline;
  const io::Source packed("input.gz", {reinterpret_cast<const char*>(data), size});
  if (!io::is_gzip(packed.bytes())) return 0;
  try {
    const io::Source source = io::unpack_gzip(packed, Run{});
    if (source.bytes().size() > io::gzip_most_expansion * size + io::gzip_spare_bytes) std::abort();
    fuzz::check_whole(io::read_any(source, Run{}));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::CannotRead) std::abort();
  }
  return 0;
}
