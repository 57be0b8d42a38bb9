// SPDX-License-Identifier: GPL-3.0-or-later
// LAS, LAZ and E57: small files of others (files/make.py) whose numbers are known, and damage done to them.
#include <cmath>
#include <cstdlib>
#include <random>

#include "io/files.h"
#include "rimline/formats.h"

namespace rimline {
namespace {

const char* const las_files[] = {"points_1.2.las", "points_1.2.laz", "points_1.4.las", "points_1.4.laz"};

std::string file(const std::string& name) { return std::string(RIMLINE_TEST_FILES) + "/" + name; }

bool is_built() {
  for (const FileFormat& format : file_formats()) {
    if (format.name == "E57") return serves(format, FormatUse::ReadPoints);
  }
  return false;
}

// What a test without the component can still see: the file is refused by name.
bool skipped() {
  if (is_built()) return false;
  MESSAGE("skipped: built without RIMLINE_SCAN_FORMATS");
  CHECK(contains(complaint("a.laz", content_of(file("points_1.4.laz"))), "built without"));
  return true;
}

TEST_CASE("LAS and LAZ give every number of every point, coordinates by scale and offset in double") {
  if (skipped()) return;
  for (const char* name : las_files) {
    CAPTURE(name);
    const Cloud cloud = read_cloud(file(name), {});
    REQUIRE(cloud.points.size() == 20);
    CHECK(cloud.coordinate_type == Scalar::Float64);
    for (int i = 0; i < 20; ++i) {
      CAPTURE(i);
      CHECK(cloud.points[i] == Point{7 * i * 0.001 + 500000, -i * 0.01 + 5400000, i * 0.1 + 0});
      const auto value = [&](const char* column) { return cloud.find(column)->value(i); };
      CHECK(value("intensity") == 100 * i);
      CHECK(value("classification") == i % 5);
      CHECK(value("return_number") == 1 + i % 2);
      CHECK(value("gps_time") == 1e8 + i / 8.0);
      CHECK(value("red") == 1000 * i);
      CHECK(value("blue") == 3000 * i);
    }
    CHECK(cloud.find("red")->type == Scalar::UInt16);
  }
  CHECK(read_cloud(file("points_1.2.laz"), {}).format == "LAZ 1.2, point format 3");
  CHECK(read_cloud(file("points_1.4.las"), {}).format == "LAS 1.4, point format 7");
}

TEST_CASE("flags and extra bytes of LAS and LAZ are columns, scaled where they say so") {
  if (skipped()) return;
  for (const std::string name : {"points_1.2.las", "points_1.4.laz", "extra_1.2.las", "extra_1.4.laz"}) {
    CAPTURE(name);
    const Cloud cloud = read_cloud(file(name), {});
    const bool extra = name.starts_with("extra"), extended = contains(name, "1.4");
    CHECK((cloud.find("overlap") != nullptr) == extended);
    CHECK((cloud.find("scanner_channel") != nullptr) == extended);
    CHECK((cloud.find("width") != nullptr) == extra);
    for (int i = 0; i < 20; ++i) {
      CAPTURE(i);
      const auto value = [&](const char* column) { return cloud.find(column)->value(i); };
      CHECK(value("scan_direction_flag") == (extra ? i % 2 : 0));
      CHECK(value("edge_of_flight_line") == (extra ? i / 2 % 2 : 0));
      CHECK(value("synthetic") == (extra ? i / 4 % 2 : 0));
      CHECK(value("key_point") == (extra ? i / 8 % 2 : 0));
      CHECK(value("withheld") == (extra ? i / 16 % 2 : 0));
      if (extended) CHECK(value("overlap") == (extra ? i % 3 == 0 : 0));
      if (extended) CHECK(value("scanner_channel") == (extra ? i % 4 : 0));
      if (!extra) continue;
      CHECK(value("width") == doctest::Approx(10 + 0.25 * i).epsilon(1e-15));
      CHECK(value("deviation") == -3 * i);
      CHECK(value("sum") == 0.5f * i);
      CHECK(value("beam_0") == i);
      CHECK(value("beam_2") == 3 * i);
    }
    if (!extra) continue;
    CHECK(cloud.find("width")->type == Scalar::Float64);
    CHECK(cloud.find("deviation")->type == Scalar::Int16);
    CHECK(cloud.find("sum")->type == Scalar::Float32);
    CHECK(cloud.find("beam_1")->type == Scalar::UInt8);
    CHECK(!contains(cloud.format, "does not describe"));
  }
}

TEST_CASE("extra bytes that nothing describes are told, and damage to their description is survived") {
  if (skipped()) return;
  std::string bytes = content_of(file("extra_1.2.las"));
  const std::size_t record = bytes.find("LASF_Spec") + 52;  // the first description, after a head of 54
  REQUIRE(record < bytes.size());
  for (int type = 0; type < 256; ++type) {
    bytes[record + 2] = static_cast<char>(type);
    const Cloud cloud = read_bytes("a.las", bytes);
    CHECK(cloud.points.size() == 20);
    const bool two_bytes = type == 3 || type == 4 || type == 11 || type == 12;
    CHECK(contains(cloud.format, "does not describe") != two_bytes);
  }
}

TEST_CASE("scans of an E57 follow each other, each moved by its pose") {
  if (skipped()) return;
  const Cloud cloud = read_cloud(file("two_scans.e57"), {});
  REQUIRE(cloud.points.size() == 40);
  CHECK(cloud.format == "E57, 2 scans");
  CHECK(cloud.unit == "m");
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    CHECK(norm(cloud.points[i] - Point{i / 4.0, -i / 2.0, 0}) == 0);
    CHECK(norm(cloud.points[20 + i] - Point{100 + i / 2.0, i / 4.0, 1}) < 1e-12);
    CHECK(cloud.find("scan")->value(i) == 0);
    CHECK(cloud.find("scan")->value(20 + i) == 1);
    CHECK(cloud.find("intensity")->value(20 + i) == i / 32.0);
    CHECK(cloud.find("green")->value(i) == 4 * i);
  }
  CHECK(cloud.find("green")->type == Scalar::UInt8);
}

TEST_CASE("an E57 in spherical coordinates has its times, returns from 1 and turned normals") {
  if (skipped()) return;
  const Cloud cloud = read_cloud(file("spherical.e57"), {});
  REQUIRE(cloud.points.size() == 20);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    const double range = 5 + i / 8.0, azimuth = i / 16.0, elevation = -i / 32.0;
    const Point before = {range * std::cos(elevation) * std::cos(azimuth),
                          range * std::cos(elevation) * std::sin(azimuth), range * std::sin(elevation)};
    CHECK(norm(cloud.points[i] - Point{100 - before.y, before.x, before.z}) < 1e-12);
    CHECK(cloud.find("time")->value(i) == i / 4.0);
    CHECK(cloud.find("return_number")->value(i) == 1 + i % 4);
    CHECK(cloud.find("number_of_returns")->value(i) == 4);
    CHECK(norm(cloud.normals()[i] - Point{0, 1, 0}) < 1e-12);
  }
  CHECK(read_cloud(file("spherical.e57"), {.returns = Returns::Last}, {}).points.size() == 5);
}

TEST_CASE("classes of a LAZ are chosen, and the points know their place in the file") {
  if (skipped()) return;
  const Cloud cloud = read_cloud(file("points_1.4.laz"), {.classes = {2, 4}}, {});
  CHECK(values(cloud, "file_index") == std::vector<double>{2, 4, 7, 9, 12, 14, 17, 19});
  CHECK(cloud.points[1].z == 4 * 0.1);
}

TEST_CASE("counts that the file has no bytes for are refused before memory is taken") {
  if (skipped()) return;
  std::string las = content_of(file("points_1.2.las"));
  las.replace(107, 4, "\xff\xff\xff\x7e");
  CHECK(contains(complaint("a.las", las), "announces"));
  std::string few = content_of(file("points_1.2.las"));
  few.replace(107, 4, std::string("\xff\x00\x00\x00", 4));
  CHECK(contains(complaint("a.las", few), "before the 255 points that its header announces"));
  std::string laz = content_of(file("points_1.2.laz"));
  laz.replace(107, 4, std::string("\xff\x00\x00\x00", 4));
  CHECK(contains(complaint("a.laz", laz), "copy it again"));
  CHECK(contains(complaint("a.las", las.substr(0, 200)), "header"));
  CHECK(contains(complaint("a.e57", content_of(file("two_scans.e57")).substr(0, 2048)), "copy it again"));
}

TEST_CASE("a memory limit stops a scan before its points are read") {
  if (skipped()) return;
  try {
    read_cloud(file("points_1.4.las"), Run{.memory_limit = 1000});
    FAIL_CHECK("was read");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::OutOfMemory);
  }
}

// The checksum of a page, as E57 has it: CRC-32C of 1,020 bytes, the largest byte first.
void mend_pages(std::string& bytes) {
  for (std::size_t page = 0; page + 1024 <= bytes.size(); page += 1024) {
    std::uint32_t crc = ~std::uint32_t{0};
    for (std::size_t i = 0; i < 1020; ++i) {
      crc ^= static_cast<unsigned char>(bytes[page + i]);
      for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0x82f63b78u : 0);
    }
    for (std::size_t i = 0; i < 4; ++i) bytes[page + 1020 + i] = static_cast<char>(~crc >> (24 - 8 * i));
  }
}

TEST_CASE("damaged LAS, LAZ and E57 are read or refused, and nothing else happens") {
  if (skipped()) return;
  std::string mended = content_of(file("two_scans.e57"));
  mend_pages(mended);
  CHECK(mended == content_of(file("two_scans.e57")));  // the checksum is the format's
  const char* asked =
      std::getenv("RIMLINE_FUZZ_ROUNDS");  // of each file; docs/formats.md tells of a long run
  const int rounds = asked != nullptr ? std::atoi(asked) : 300;
  std::mt19937 random(5);
  std::size_t read = 0, refused = 0;
  for (const std::string name : {"points_1.2.las", "points_1.2.laz", "points_1.4.las", "points_1.4.laz",
                                 "two_scans.e57", "spherical.e57"}) {
    const std::string whole = content_of(file(name));
    for (int trial = 0; trial < rounds; ++trial) {
      std::string bytes = whole;
      for (int change = random() % 4; change >= 0; --change)
        bytes[random() % bytes.size()] = static_cast<char>(random());
      if (trial % 5 == 0) bytes.resize(random() % bytes.size());
      if (name.ends_with("e57")) mend_pages(bytes);
      try {
        read_bytes(name, bytes, Run{.memory_limit = std::size_t{1} << 28});
        ++read;
      } catch (const Error& error) {
        CHECK((error.code() == ErrorCode::CannotRead || error.code() == ErrorCode::OutOfMemory));
        ++refused;
      }
    }
  }
  CHECK(read > 100);
  CHECK(refused > 100);
}

}  // namespace
}  // namespace rimline
