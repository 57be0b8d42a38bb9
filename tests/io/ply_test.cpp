// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "io/files.h"

namespace rimline {
namespace {

const std::string xyz_float = "property float x\nproperty float y\nproperty float z\n";

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

std::string ascii(const std::string& elements, const std::string& body) {
  return header("ascii", elements) + body;
}

TEST_CASE("an ascii PLY with comments, CR LF and blank lines is read") {
  const Cloud cloud =
      read_bytes("a.ply",
                 "ply\r\ncomment made by hand\r\nformat ascii 1.0\r\nobj_info x\r\nelement vertex 2\r\n"
                 "property float x\r\nproperty float y\r\nproperty float z\r\nend_header\r\n"
                 "1 2 3\r\n\r\n  4\t5e0 +6 \r\n");
  CHECK(cloud.points == std::vector<Point>{{1, 2, 3}, {4, 5, 6}});
  CHECK(cloud.coordinate_type == Scalar::Float32);
}

TEST_CASE("text of float coordinates is rounded once, to the nearest float") {
  // Halfway between two floats but for a last digit that double drops.
  const std::string tie = "1.00000005960464477539062500000000001";
  const Cloud cloud = read_bytes("a.ply", ascii("element vertex 1\n" + xyz_float, tie + " 0.1 0\n"));
  CHECK(cloud.points[0].x == static_cast<double>(std::nextafter(1.0f, 2.0f)));
  CHECK(cloud.points[0].y == static_cast<double>(0.1f));
}

TEST_CASE("every scalar type passes through in order, in both binary orders and in ascii") {
  const std::string elements =
      "element vertex 1\nproperty char a\nproperty uint8 b\nproperty double x\nproperty int16 c\nproperty "
      "ushort d\n"
      "property float64 y\nproperty int e\nproperty uint32 f\nproperty double z\nproperty float32 "
      "g\nproperty double h\n";
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const bool big = format == "binary_big_endian";
    const std::string body =
        format == "ascii" ? "-128 255 0.001 -32768 65535 1e7 -2147483648 4294967295 3 0.1 0.2\n"
                          : bytes_of(std::int8_t{-128}) + bytes_of(std::uint8_t{255}) + bytes_of(0.001, big) +
                                bytes_of(std::int16_t{-32768}, big) + bytes_of(std::uint16_t{65535}, big) +
                                bytes_of(1e7, big) + bytes_of(std::int32_t{-2147483647 - 1}, big) +
                                bytes_of(std::uint32_t{4294967295u}, big) + bytes_of(3.0, big) +
                                bytes_of(0.1f, big) + bytes_of(0.2, big);
    CAPTURE(format);
    const Cloud cloud = read_bytes("a.ply", header(format, elements) + body);
    CHECK(cloud.points == std::vector<Point>{{0.001, 1e7, 3}});
    CHECK(cloud.coordinate_type == Scalar::Float64);
    std::string order;
    for (const Column& column : cloud.columns) order += column.name + ":" + name(column.type) + " ";
    CHECK(order == "a:char b:uchar c:short d:ushort e:int f:uint g:float h:double ");
    CHECK(values(cloud, "a")[0] == -128);
    CHECK(values(cloud, "b")[0] == 255);
    CHECK(values(cloud, "c")[0] == -32768);
    CHECK(values(cloud, "d")[0] == 65535);
    CHECK(values(cloud, "e")[0] == -2147483648.0);
    CHECK(values(cloud, "f")[0] == 4294967295.0);
    CHECK(values(cloud, "g")[0] == static_cast<double>(0.1f));
    CHECK(values(cloud, "h")[0] == 0.2);
  }
}

TEST_CASE("integer coordinates are read as doubles") {
  const Cloud cloud = read_bytes(
      "a.ply",
      ascii("element vertex 1\nproperty int x\nproperty uchar y\nproperty short z\n", "2147483647 255 -3\n"));
  CHECK(cloud.points == std::vector<Point>{{2147483647, 255, -3}});
  CHECK(cloud.coordinate_type == Scalar::Float64);
}

TEST_CASE("elements before and after the vertices and lists among them are stepped over") {
  const std::string elements =
      "element camera 1\nproperty float f\nelement strip 2\nproperty list int uchar s\nelement vertex 2\n"
      "property float x\nproperty list uchar short neighbours\nproperty float y\nproperty float z\nproperty "
      "uchar q\n"
      "element face 1\nproperty list uchar int vertex_indices\n";
  const std::vector<Point> expected = {{1, 2, 3}, {4, 5, 6}};
  const Cloud text =
      read_bytes("a.ply", ascii(elements, "0.5\n3 1 2 3\n0\n1 2 10 11 2 3 7\n4 0 5 6 8\n3 0 1 1\n"));
  CHECK(text.points == expected);
  CHECK(values(text, "q") == std::vector<double>{7, 8});
  const std::string body = bytes_of(0.5f, true) + bytes_of(std::int32_t{3}, true) + "abc" +
                           bytes_of(std::int32_t{0}, true) + bytes_of(1.0f, true) + "\x02" + "aabb" +
                           bytes_of(2.0f, true) + bytes_of(3.0f, true) + "\x07" + bytes_of(4.0f, true) +
                           std::string(1, '\0') + bytes_of(5.0f, true) + bytes_of(6.0f, true) + "\x08";
  const Cloud binary = read_bytes("a.ply", header("binary_big_endian", elements) + body);
  CHECK(binary.points == expected);
  CHECK(values(binary, "q") == std::vector<double>{7, 8});
}

TEST_CASE("data that looks like a line end after the header is data") {
  const std::string header_text = header(
      "binary_little_endian", "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n");
  CHECK(read_bytes("a.ply", header_text + "\n\r\n").points == std::vector<Point>{{10, 13, 10}});
}

TEST_CASE("rows with nan and inf are kept, and the bits of a signalling NaN in a column too") {
  const Cloud cloud = read_bytes("a.ply", ascii("element vertex 2\n" + xyz_float, "nan 1 2\n-inf INF 3\n"));
  REQUIRE(cloud.points.size() == 2);
  CHECK(std::isnan(cloud.points[0].x));
  CHECK(cloud.points[1].x == -std::numeric_limits<double>::infinity());
  const std::string rgb = "\x01\x02\xa3\x7f";
  const Cloud binary = read_bytes(
      "a.ply", header("binary_little_endian", "element vertex 1\n" + xyz_float + "property float rgb\n") +
                   bytes_of(1.0f) + bytes_of(2.0f) + bytes_of(3.0f) + rgb);
  CHECK(std::memcmp(binary.columns[0].bytes.data(), rgb.data(), 4) == 0);
}

TEST_CASE("64-bit integers become doubles where they fit and two columns where they do not") {
  const std::string elements = "element vertex 2\n" + xyz_float + "property int64 t\nproperty uint64 u\n";
  const Cloud cloud =
      read_bytes("a.ply", ascii(elements, "0 0 0 -5 1\n1 0 0 9007199254740992 18446744073709551615\n"));
  CHECK(values(cloud, "t") == std::vector<double>{-5, 9007199254740992.0});
  CHECK(cloud.find("u") == nullptr);
  CHECK(values(cloud, "u_low") == std::vector<double>{1, 4294967295.0});
  CHECK(values(cloud, "u_high") == std::vector<double>{0, 4294967295.0});
}

TEST_CASE("a cloud that is written is read back with the same bytes") {
  std::mt19937_64 random(7);
  const auto bits = [&] { return static_cast<double>(random() >> 11) / 1e12 - 3000; };
  Cloud cloud;
  std::vector<double> doubles;
  std::vector<float> floats;
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 20000; ++i) {
    cloud.points.push_back({bits(), bits(), bits()});
    doubles.push_back(bits());
    floats.push_back(static_cast<float>(bits()));
    bytes.push_back(static_cast<std::uint8_t>(random()));
  }
  cloud.columns = {make_column("red", bytes), make_column("d", doubles), make_column("f", floats)};
  const TemporaryDirectory directory;
  for (const Scalar type : {Scalar::Float64, Scalar::Float32}) {
    cloud.coordinate_type = type;
    if (type == Scalar::Float32) {
      for (Point& p : cloud.points) {
        p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
      }
    }
    write_cloud(directory.file("a.ply"), cloud, {});
    const Cloud back = read_cloud(directory.file("a.ply"), {});
    CHECK(back.points == cloud.points);
    CHECK(back.coordinate_type == type);
    REQUIRE(back.columns.size() == 3);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(back.columns[c].name == cloud.columns[c].name);
      CHECK(back.columns[c].type == cloud.columns[c].type);
      CHECK(back.columns[c].bytes == cloud.columns[c].bytes);
    }
    write_cloud(directory.file("b.ply"), back, {});
    CHECK(content_of(directory.file("a.ply")) == content_of(directory.file("b.ply")));
  }
}

TEST_CASE("a mesh in PLY has the header that other programs expect") {
  const TemporaryDirectory directory;
  Cloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  cloud.coordinate_type = Scalar::Float32;
  set_column(cloud, make_column("u", std::vector<double>{0, 1, 0}));
  write_mesh(directory.file("m.ply"), cloud, {{0, 1, 2}}, {});
  const std::string text = content_of(directory.file("m.ply"));
  const std::string expected =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "float z\n"
      "property double u\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  CHECK(text.substr(0, expected.size()) == expected);
  CHECK(text.size() == expected.size() + 3 * 20 + 13);
  CHECK(text.substr(text.size() - 13) == std::string("\x03") + bytes_of(0) + bytes_of(1) + bytes_of(2));
}

TEST_CASE("bad PLY files are named with their place") {
  const std::string vertex = "element vertex 2\n" + xyz_float;
  CHECK(contains(complaint("a.ply", ascii(vertex, "1 2 3\n4 x 6\n")),
                 "a.ply, line 9: 'x' is no value for property 'y'"));
  CHECK(contains(complaint("a.ply", ascii(vertex, "1 2 3\n4 5\n")),
                 "line 9: the value of property 'z' is missing"));
  CHECK(contains(complaint("a.ply", ascii(vertex, "1 2 3 4\n5 6 7\n")), "line 8: more values"));
  CHECK(contains(complaint("a.ply", ascii(vertex, "1 2 3\n")), "before the 2 records of element 'vertex'"));
  CHECK(contains(complaint("a.ply", header("binary_little_endian", vertex) + "12345678901"), "truncated"));
  CHECK(contains(
      complaint("a.ply", header("binary_little_endian", "element vertex 1000000000000\n" + xyz_float)),
      "at most 2147483646"));
  CHECK(contains(complaint("a.ply", header("ascii", "element vertex 2000000000\n" + xyz_float) + "1 2 3\n"),
                 "truncated"));
  CHECK(
      contains(complaint("a.ply", header("binary_little_endian",
                                         "element junk 18446744073709551615\nproperty double a\n" + vertex)),
               "'junk'"));
  CHECK(contains(complaint("a.ply", ascii("element vertex 0\n" + xyz_float, "")), "has no points"));
  CHECK(contains(complaint("a.ply", ascii("element vertex 1\nproperty float x\nproperty float y\n", "1 2\n")),
                 "no property 'z'"));
  CHECK(contains(complaint("a.ply", ascii("element face 1\nproperty list uchar int v\n", "1 2\n")),
                 "no element 'vertex'"));
  CHECK(contains(complaint("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n"),
                 "line 4: unknown type 'quad'"));
  CHECK(contains(complaint("a.ply", "ply\nformat ebcdic 1.0\nend_header\n"),
                 "line 2: unknown PLY format 'ebcdic'"));
  CHECK(contains(complaint("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), "no 'end_header'"));
  CHECK(contains(complaint("a.ply", "ply\nformat ascii 1.0\nelement vertex many\nend_header\n"), "line 3"));
  CHECK(contains(
      complaint("a.ply", ascii("element vertex 1\nproperty float x\nproperty float y\nproperty uchar z\n",
                               "1 2 256\n")),
      "'256' is no value"));
  const std::string listed = "element vertex 1\n" + xyz_float + "property list int int l\n";
  CHECK(contains(complaint("a.ply", header("binary_little_endian", listed) + bytes_of(1.0) + bytes_of(1.0f) +
                                        bytes_of(-1)),
                 "negative"));
  CHECK(contains(complaint("a.ply", header("binary_little_endian", listed) + bytes_of(1.0) + bytes_of(1.0f) +
                                        bytes_of(2000000000)),
                 "truncated"));
}

}  // namespace
}  // namespace rimline
