// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a file without an ending: the format is told by the content.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/readers.h"
#include "whole.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rimline;
  try {
    fuzz::check_whole(io::read_any(io::Source("input", {reinterpret_cast<const char*>(data), size}), Run{}));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::CannotRead) std::abort();
  }
  return 0;
}
