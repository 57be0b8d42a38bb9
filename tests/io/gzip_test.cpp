// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include "io/files.h"

namespace rimline {
namespace {

std::string packed(const std::string& text) {
  z_stream state{};
  deflateInit2(&state, Z_BEST_COMPRESSION, Z_DEFLATED, 16 + MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
  std::string result(deflateBound(&state, text.size()), '\0');
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  state.avail_in = static_cast<uInt>(text.size());
  state.next_out = reinterpret_cast<Bytef*>(result.data());
  state.avail_out = static_cast<uInt>(result.size());
  deflate(&state, Z_FINISH);
  result.resize(state.total_out);
  deflateEnd(&state);
  return result;
}

std::string refusal(const std::string& bytes, const Run& run = {}) {
  const TemporaryDirectory folder;
  try {
    read_cloud(folder.file("a.xyz.gz", bytes), run);
  } catch (const Error& error) {
    return error.what();
  }
  return "was read";
}

TEST_CASE("gzip is told by its content, whatever the name, and may have several members") {
  const TemporaryDirectory folder;
  const std::vector<Point> expected = {{1, 2, 3}, {4, 5, 6}};
  const std::string both = packed("1 2 3\n") + packed("4 5 6\n");
  for (const char* name : {"a.xyz.gz", "a.xyz", "a"}) {
    CAPTURE(name);
    const Cloud cloud = read_cloud(folder.file(name, both), {});
    CHECK(cloud.points == expected);
    CHECK(cloud.format == "XYZ/TXT/CSV, in gzip");
  }
  const std::string off = packed("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");  // without its keyword
  CHECK(read_cloud(folder.file("a.off.gz", off), {}).format == "OFF, in gzip");
  CHECK(read_mesh(folder.file("b.off.gz", off), {}).triangles.size() == 1);
}

TEST_CASE("what is unpacked is as long as it should be, beyond the buffer's first size") {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += std::to_string(i * 7919 % 100003) + " 2 3\n";
  const TemporaryDirectory folder;
  const Cloud cloud = read_cloud(folder.file("a.gz", packed(text)), {});
  REQUIRE(cloud.points.size() == 100000);
  CHECK(cloud.points[99999].x == 99999 * 7919L % 100003);
}

TEST_CASE("damaged, cut and endless gzip is refused") {
  const std::string whole = packed("1 2 3\n4 5 6\n");
  CHECK(contains(refusal(whole.substr(0, whole.size() - 9)), "truncated"));
  CHECK(contains(refusal(whole.substr(0, 10)), "truncated"));
  std::string damaged = whole;
  damaged[whole.size() - 6] ^= 1;  // of the checksum
  CHECK(contains(refusal(damaged), "damaged"));
  CHECK(contains(refusal(packed(whole)), "twice"));
  const std::string bomb = packed(std::string(std::size_t{80} << 20, ' '));
  CHECK(contains(refusal(bomb), "more than 200 times its size"));
  CHECK(contains(refusal(bomb, Run{.memory_limit = 1 << 20}), "memory limit"));
}

}  // namespace
}  // namespace rimline
