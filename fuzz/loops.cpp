// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as LOOPS.json: refused as CannotRead, or loops that are read back as they were written.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/readers.h"
#include "rimline/io.h"

namespace {

using namespace rimline;

constexpr std::size_t points = 64;

std::vector<Loop> read(std::string_view text) { return io::read_loops(io::Source("input", text), points); }

void check_round_trip(const std::vector<Loop>& loops) {
  const std::vector<Loop> again = read(loops_to_json(loops, points));
  if (again.size() != loops.size()) std::abort();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (again[i].points != loops[i].points || again[i].kind != loops[i].kind) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check_round_trip(read({reinterpret_cast<const char*>(data), size}));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::CannotRead) std::abort();
  }
  return 0;
}
