// SPDX-License-Identifier: GPL-3.0-or-later
#include <liblzf/lzf.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "io/files.h"
#include "io/lzf.h"

namespace rimline {
namespace {

std::string header(int count, const std::string& data) {
  const std::string n = std::to_string(count);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z normal_x rgb ring pair _\n"
         "SIZE 4 4 4 4 4 2 1 1\nTYPE F F F F F U I U\nCOUNT 1 1 1 1 1 1 2 3\nWIDTH " +
         n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA " + data + "\n";
}

struct Record {
  float x, y, z, nx;
  std::uint32_t rgb;
  std::uint16_t ring;
  std::int8_t pair[2];
};

const std::vector<Record> records = {{1, 2, 3, 0.5f, 0x7fa00102u, 65535, {-128, 127}},
                                     {std::nanf(""), 5, 6, -0.5f, 0x00ff8001u, 7, {1, 2}}};

std::string row_by_row() {
  std::string bytes;
  for (const Record& r : records) {
    bytes += bytes_of(r.x) + bytes_of(r.y) + bytes_of(r.z) + bytes_of(r.nx) + bytes_of(r.rgb) +
             bytes_of(r.ring) + bytes_of(r.pair[0]) + bytes_of(r.pair[1]) + "___";
  }
  return bytes;
}

std::string field_by_field() {
  std::string bytes;
  for (const Record& r : records) bytes += bytes_of(r.x);
  for (const Record& r : records) bytes += bytes_of(r.y);
  for (const Record& r : records) bytes += bytes_of(r.z);
  for (const Record& r : records) bytes += bytes_of(r.nx);
  for (const Record& r : records) bytes += bytes_of(r.rgb);
  for (const Record& r : records) bytes += bytes_of(r.ring);
  for (const Record& r : records) bytes += bytes_of(r.pair[0]) + bytes_of(r.pair[1]);
  return bytes + "______";
}

std::string compressed(const std::string& bytes) {
  std::string packed(2 * bytes.size() + 64, '\0');
  packed.resize(lzf_compress(bytes.data(), static_cast<unsigned>(bytes.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  return packed;
}

std::string compressed_body(const std::string& bytes) {
  const std::string packed = compressed(bytes);
  return bytes_of(static_cast<std::uint32_t>(packed.size())) +
         bytes_of(static_cast<std::uint32_t>(bytes.size())) + packed;
}

void check_records(const Cloud& cloud, bool exact_rgb) {
  REQUIRE(cloud.points.size() == 2);
  CHECK(cloud.points[0] == Point{1, 2, 3});
  CHECK(std::isnan(cloud.points[1].x));
  CHECK(cloud.points[1].z == 6);
  CHECK(cloud.coordinate_type == Scalar::Float32);
  CHECK(cloud.columns.size() == 5);
  CHECK(values(cloud, "nx") == std::vector<double>{0.5, -0.5});
  CHECK(values(cloud, "ring") == std::vector<double>{65535, 7});
  CHECK(values(cloud, "pair_0") == std::vector<double>{-128, 1});
  CHECK(values(cloud, "pair_1") == std::vector<double>{127, 2});
  if (exact_rgb) CHECK(std::memcmp(cloud.find("rgb")->bytes.data(), &records[0].rgb, 4) == 0);
}

TEST_CASE("the three kinds of PCD data give the same cloud") {
  check_records(read_bytes("a.pcd", header(2, "binary") + row_by_row()), true);
  check_records(read_bytes("a.pcd", header(2, "binary_compressed") + compressed_body(field_by_field())),
                true);
  check_records(read_bytes("a.pcd", header(2, "ascii") +
                                        "1 2 3 0.5 0 65535 -128 127 0 0 0\nnan 5 6 -.5 0 7 1 2 0 0 0\n"),
                false);
}

TEST_CASE("a PCD without COUNT and POINTS is as large as WIDTH times HEIGHT") {
  const std::string start =
      "VERSION .5\nCOLUMNS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 2\nHEIGHT 2\nDATA ascii\n";
  const Cloud cloud = read_bytes("a.pcd", start + "1 2 3\n4 5 6\n7 8 9\n0.1 0 0\n");
  CHECK(cloud.points.size() == 4);
  CHECK(cloud.points[3].x == 0.1);
  CHECK(cloud.coordinate_type == Scalar::Float64);
}

TEST_CASE("what liblzf compresses is decompressed to the same bytes") {
  std::mt19937_64 random(3);
  for (int round = 0; round < 200; ++round) {
    std::string text(1 + random() % 5000, '\0');
    const unsigned letters = 1 + round % 8;  // few letters: long copies, many: literals
    for (char& c : text) c = static_cast<char>(letters == 8 ? random() : random() % letters);
    const std::string packed = compressed(text);
    REQUIRE_FALSE(packed.empty());
    std::string back(text.size(), '?');
    CHECK(io::lzf_decompress(packed, back.data(), back.size()));
    CHECK(back == text);
    CHECK_FALSE(io::lzf_decompress(packed.substr(0, packed.size() - 1), back.data(), back.size()));
  }
}

TEST_CASE("bad PCD files are named") {
  CHECK(contains(complaint("a.pcd", header(3, "binary") + row_by_row()), "before the 3 points"));
  CHECK(contains(complaint("a.pcd", header(2, "ascii") + "1 2 3 0.5 0 65535 -128 127 0 0 0\n"),
                 "before the 2 points"));
  CHECK(contains(complaint("a.pcd", header(2, "ascii") + "1 2 3 0.5 0 65535 -128 127 0 0 0\n1 2 nan 0 7 1\n"),
                 "line 13: the value of field 'pair_0' is missing"));
  CHECK(contains(complaint("a.pcd", header(3, "binary_compressed") + compressed_body(field_by_field())),
                 "do not fit the 3 points"));
  std::string damaged = header(2, "binary_compressed") + compressed_body(field_by_field());
  damaged[damaged.size() - 20] = '\xff';
  CHECK(contains(complaint("a.pcd", damaged.substr(0, damaged.size() - 3)), "truncated"));
  CHECK(contains(complaint("a.pcd", header(2, "zipped")), "unknown PCD data 'zipped'"));
  CHECK(contains(complaint("a.pcd", "# .PCD v0.7\nFIELDS x y z\n"), "no line DATA"));
  CHECK(contains(
      complaint("a.pcd", "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n"),
      "SIZE 3"));
  CHECK(contains(complaint("a.pcd", "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4\nPOINTS 1\nDATA ascii\n1 2 3\n"),
                 "line 3: fewer values"));
  CHECK(contains(
      complaint("a.pcd", "# .PCD v0.7\nFIELDS x y z\nWIDTH 3\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n"),
      "WIDTH times HEIGHT is 3"));
}

}  // namespace
}  // namespace rimline
