// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>

namespace rimline::io {
namespace {

constexpr std::size_t most_per_call = std::size_t{1} << 24;  // bytes between two looks at Run

// zlib's state, from the first byte of a member.
class Inflater {
 public:
  Inflater() {
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&state_, gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&state_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Unpacks from `in` to `out` and removes what was used from both; returns Z_OK, Z_STREAM_END, or the error.
  int step(std::string_view& in, char*& out, std::size_t room) {
    const std::size_t take = std::min(in.size(), most_per_call);
    state_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(in.data()));
    state_.avail_in = static_cast<uInt>(take);
    state_.next_out = reinterpret_cast<Bytef*>(out);
    state_.avail_out = static_cast<uInt>(std::min(room, most_per_call));
    const uInt had = state_.avail_out;
    const int result = inflate(&state_, Z_NO_FLUSH);
    in.remove_prefix(take - state_.avail_in);
    out += had - state_.avail_out;
    return result;
  }
  void next_member() { inflateReset(&state_); }

 private:
  z_stream state_{};
};

struct Buffer {
  std::unique_ptr<char[]> storage;
  std::size_t size = 0, room = 0;

  void grow(std::size_t most) {
    const std::size_t larger = std::min(std::max<std::size_t>(2 * room, std::size_t{1} << 16), most);
    auto next = std::make_unique_for_overwrite<char[]>(larger);
    if (size > 0) std::memcpy(next.get(), storage.get(), size);
    storage = std::move(next);
    room = larger;
  }
};

void check_room(const Source& packed, const Buffer& buffer, std::size_t most, const Run& run) {
  if (run.memory_limit != 0 && buffer.size >= run.memory_limit) {
    throw Error(ErrorCode::OutOfMemory, packed.name() + ": unpacks to more than the memory limit of " +
                                            std::to_string(run.memory_limit) +
                                            " bytes; raise the limit or thin the cloud");
  }
  if (buffer.size < most) return;
  packed.fail("unpacks to more than " + std::to_string(gzip_most_expansion) +
              " times its size, as no cloud does; unpack it first (gunzip -k) if it is meant");
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

Source unpack_gzip(const Source& packed, const Run& run) {
  const std::size_t most = gzip_most_expansion * packed.bytes().size() + gzip_spare_bytes;
  Inflater inflater;
  Buffer buffer;
  std::string_view in = packed.bytes();
  for (;;) {
    run.check_cancel();
    if (buffer.size == buffer.room) {
      check_room(packed, buffer, most, run);
      buffer.grow(most);
    }
    char* out = buffer.storage.get() + buffer.size;
    const int result = inflater.step(in, out, buffer.room - buffer.size);
    buffer.size = static_cast<std::size_t>(out - buffer.storage.get());
    if (result == Z_STREAM_END) {
      if (!is_gzip(in)) break;  // zeros may follow, as tapes pad
      inflater.next_member();
    } else if (result == Z_BUF_ERROR || (result == Z_OK && in.empty() && buffer.size < buffer.room)) {
      packed.fail_at_byte(in.data(), "the gzip data end too early; the file is truncated: copy it again");
    } else if (result != Z_OK) {
      packed.fail_at_byte(in.data(), "the gzip data are damaged; copy the file again");
    }
  }
  Source unpacked(packed.name(), std::move(buffer.storage), buffer.size);
  unpacked.set_packing("gzip");
  return unpacked;
}

}  // namespace rimline::io
