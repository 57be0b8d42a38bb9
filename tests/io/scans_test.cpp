// SPDX-License-Identifier: GPL-3.0-or-later
// PTX, NPY and glTF binary: files put together here, byte for byte.
#include <cmath>

#include "io/files.h"

namespace rimline {
namespace {

const std::string ptx_head =
    "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n100 200 300 1\n";  // a quarter turn

TEST_CASE("each scan of a PTX is moved by its matrix, and cells without a return have no place") {
  const std::string plain = "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  const Cloud cloud = read_bytes(
      "a.ptx", ptx_head + "1 2 3 0.5 10 20 30\n0 0 0 0.5 0 0 0\n" + plain + "7 8 9 1 1 2 3\n4 5 6 0 4 5 6\n");
  REQUIRE(cloud.points.size() == 4);
  CHECK(cloud.points[0] == Point{98, 201, 303});
  CHECK(std::isnan(cloud.points[1].x));
  CHECK(cloud.points[2] == Point{7, 8, 9});
  CHECK(values(cloud, "scan") == std::vector<double>{0, 0, 1, 1});
  CHECK(values(cloud, "column") == std::vector<double>{0, 1, 0, 0});
  CHECK(values(cloud, "row") == std::vector<double>{0, 0, 0, 1});
  CHECK(values(cloud, "blue") == std::vector<double>{30, 0, 3, 6});
  CHECK(values(cloud, "intensity") == std::vector<double>{0.5, 0.5, 1, 0});
  CHECK(cloud.format == "PTX, 2 scans");
}

TEST_CASE("a PTX that is wrong is told by its line") {
  CHECK(contains(complaint("a.ptx", ptx_head + "1 2 3 0.5\n"),
                 "line 1: is a PTX file whose scan here announces 2 cells"));
  CHECK(contains(complaint("a.ptx", ptx_head + "1 2 3 0.5\n\n\n\n\n\n\n\n\n"),
                 "is a PTX file that ends within a scan"));
  CHECK(contains(complaint("a.ptx", ptx_head + "1 2 3 0.5\n1 2 three 4\n"), "line 12: a cell of a PTX"));
  CHECK(contains(complaint("a.ptx", ptx_head + "1 2 3 0.5\n1 2 3 4 5 6 7\n"), "line 12: this cell has 7"));
  CHECK(contains(complaint("a.ptx", ptx_head + "1 2 3 0.5\n1 2 3 4\n1 2 3 4\n"),
                 "line 13: a scan of a PTX starts"));
  CHECK(contains(complaint("a.ptx", "x\n"), "does not start as PTX does"));
}

std::string npy(const std::string& header, const std::string& body, int version = 1) {
  const std::string padded = header + std::string(64 - (10 + header.size()) % 64, ' ') + "\n";
  return std::string("\x93NUMPY", 6) + static_cast<char>(version) + std::string(1, '\0') +
         (version == 1 ? bytes_of(static_cast<std::uint16_t>(padded.size()))
                       : bytes_of(static_cast<std::uint32_t>(padded.size()))) +
         padded + body;
}

template <class T>
std::string bytes_of_all(const std::vector<T>& values, bool turned = false) {
  std::string bytes;
  for (const T value : values) bytes += bytes_of(value, turned);
  return bytes;
}

TEST_CASE("NPY arrays of every order, type and number of axes give their rows") {
  const std::vector<Point> expected = {{1, 2, 3}, {4, 5, 6}};
  const std::string c = "'fortran_order': False, ", f = "'fortran_order': True, ";
  const auto doubles = bytes_of_all<double>({1, 2, 3, 4, 5, 6});
  CHECK(read_bytes("a.npy", npy("{'descr': '<f8', " + c + "'shape': (2, 3), }", doubles)).points == expected);
  CHECK(read_bytes("a", npy("{'descr': '<f8', " + c + "'shape': (2, 3), }", doubles, 2)).points == expected);
  CHECK(read_bytes("a", npy("{'descr': '<f8', " + c + "'shape': (1, 2, 3)}", doubles)).points == expected);
  const auto columns = bytes_of_all<float>({1, 4, 2, 5, 3, 6});
  const Cloud floats = read_bytes("a", npy("{'descr': '<f4', " + f + "'shape': (2, 3), }", columns));
  CHECK(floats.points == expected);
  CHECK(floats.coordinate_type == Scalar::Float32);
  const auto big = bytes_of_all<std::int32_t>({1, 2, 3, 4, 5, 6}, true);
  CHECK(read_bytes("a", npy("{'descr': '>i4', " + c + "'shape': (2, 3), }", big)).points == expected);
  const Cloud four = read_bytes("a", npy("{'descr': '<f4', " + c + "'shape': (2, 4), }",
                                         bytes_of_all<float>({1, 2, 3, 9, 4, 5, 6, 8})));
  CHECK(four.points == expected);
  CHECK(values(four, "intensity") == std::vector<double>{9, 8});
  CHECK(contains(four.warnings.at(0), "x y z intensity"));
}

TEST_CASE("NPY records give their fields") {
  const std::string body = bytes_of<std::uint8_t>(7) + bytes_of_all<double>({1, 2, 3});
  const Cloud cloud =
      read_bytes("a", npy("{'descr': [('c', '|u1'), ('x', '<f8'), ('y', '<f8'), ('z', '<f8')], "
                          "'fortran_order': False, 'shape': (1,), }",
                          body));
  CHECK(cloud.points == std::vector<Point>{{1, 2, 3}});
  CHECK(cloud.find("c")->type == Scalar::UInt8);
}

TEST_CASE("NPY halves become the floats that they are, in either order of bytes") {
  // Of IEEE 754: 1, -2, 65504 (the most), 2^-24 (the least), 1/3 rounded, -infinity.
  const std::vector<std::uint16_t> halves = {0x3C00, 0xC000, 0x7BFF, 0x0001, 0x3555, 0xFC00};
  for (const bool turned : {false, true}) {
    const std::string type = turned ? "'>f2'" : "'<f2'";
    const Cloud cloud =
        read_bytes("a", npy("{'descr': " + type + ", 'fortran_order': False, 'shape': (2, 3), }",
                            bytes_of_all(halves, turned)));
    CHECK(cloud.coordinate_type == Scalar::Float32);
    CHECK(cloud.points[0] == Point{1, -2, 65504});
    CHECK(cloud.points[1] == Point{0x1p-24, 0x1.554p-2, -std::numeric_limits<double>::infinity()});
  }
  const std::string nan = bytes_of_all<std::uint16_t>({0, 0x8000, 0x7E01});
  const Cloud odd = read_bytes("a", npy("{'descr': '<f2', 'fortran_order': True, 'shape': (1, 3), }", nan));
  CHECK(odd.points[0].x == 0);
  CHECK(std::signbit(odd.points[0].y));
  CHECK(std::isnan(odd.points[0].z));
}

TEST_CASE("NPY records may mix orders of bytes and halves") {
  const auto record = [](double x, float y, std::uint16_t z, std::uint16_t count) {
    return bytes_of(x) + bytes_of(y, true) + bytes_of(z, true) + bytes_of(count);
  };
  const Cloud cloud =
      read_bytes("a", npy("{'descr': [('x', '<f8'), ('y', '>f4'), ('z', '>f2'), ('c', '<u2')], "
                          "'fortran_order': False, 'shape': (2,), }",
                          record(1, 2, 0x4200, 7) + record(0.1, 0.5, 0xB800, 65535)));
  CHECK(cloud.points == std::vector<Point>{{1, 2, 3}, {0.1, 0.5, -0.5}});
  CHECK(values(cloud, "c") == std::vector<double>{7, 65535});
}

TEST_CASE("an NPY that is wrong is told with the remedy") {
  const std::string c = "'fortran_order': False, ", six = bytes_of_all<double>({1, 2, 3, 4, 5, 6});
  CHECK(contains(complaint("a", npy("{'descr': '<f8', " + c + "'shape': (3, 3), }", six)), "truncated"));
  CHECK(contains(complaint("a", npy("{'descr': '<f8', " + c + "'shape': (4611686018427387904, 3), }", six)),
                 "truncated"));
  CHECK(contains(complaint("a", npy("{'descr': '<f2', " + c + "'shape': (9, 3), }", six)), "truncated"));
  CHECK(contains(
      complaint("a", npy("{'descr': [('x', '<f8'), ('y', '<f8'), ('z', '<f8')], " + c + "'shape': ()}",
                         "twenty-three bytes here")),
      "truncated"));
  CHECK(contains(complaint("a", npy("{'descr': '<f8', " + c + "'shape': (6,), }", six)), "without rows"));
  CHECK(contains(complaint("a", npy("{'descr': '<f8', " + c + "'shape': (3, 2), }", six)), "without rows"));
  CHECK(contains(complaint("a", npy("{'descr': '<U4', " + c + "'shape': (2, 3), }", six)),
                 "'<U4' is not known"));
  CHECK(contains(complaint("a", npy("{'descr': '<f8', " + c + "'shape': (3, 20), }",
                                    bytes_of_all<double>(std::vector<double>(60, 1.0)))),
                 "numpy.save(FILE, a.T)"));
  CHECK(contains(complaint("a", npy("{'descr': '<f8', " + c, six)), "NPY header"));
  CHECK(contains(complaint("a", std::string("\x93NUMPY\x01\x00\xff", 9)), "within its NPY header"));
}

TEST_CASE("a glTF binary gives back what was written, to a float about its middle") {
  Cloud cloud;
  for (int i = 0; i < 50; ++i)
    cloud.points.push_back({500000.0 + 0.1 * i, 5400000.0 + 0.3 * (i % 7), 0.01 * i});
  std::vector<std::uint8_t> red(50, 10), green(50, 200), blue(50, 255);
  cloud.columns = {make_column("red", red), make_column("green", green), make_column("blue", blue)};
  const TemporaryDirectory folder;
  write_mesh(folder.file("a.glb"), cloud, {{0, 1, 2}, {3, 4, 5}}, {});
  const MeshFile back = read_mesh(folder.file("a.glb"), {});
  REQUIRE(back.cloud.points.size() == 50);
  for (std::size_t i = 0; i < 50; ++i) CHECK(norm(back.cloud.points[i] - cloud.points[i]) < 1e-6);
  CHECK(values(back.cloud, "green")[7] == 200);
  CHECK(back.cloud.normals().size() == 50);
  CHECK(back.triangles == std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}});
}

std::string glb(const std::string& json, const std::string& buffer) {
  const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
  const auto number = [](std::size_t n) { return bytes_of(static_cast<std::uint32_t>(n)); };
  return "glTF" + number(2) + number(28 + text.size() + buffer.size()) + number(text.size()) + "JSON" + text +
         number(buffer.size()) + std::string("BIN\0", 4) + buffer;
}

const std::string views =
    R"("bufferViews": [{"buffer": 0, "byteLength": 12}], "buffers": [{"byteLength": 12}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 1, "type": "VEC3"}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}], "asset": {"version": "2.0"})";

TEST_CASE("nodes of a glTF binary place what they hold, one in the other, as often as it is shown") {
  const std::string nodes =
      R"({"scene": 0, "scenes": [{"nodes": [0, 2]}], "nodes": [{"translation": [10, 0, 0], "children": [1]},
      {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 2, 2]}, {"mesh": 0}], )";
  const Cloud cloud = read_bytes("a.glb", glb(nodes + views + "}", bytes_of_all<float>({1, 0, 3})));
  REQUIRE(cloud.points.size() == 2);
  CHECK(norm(cloud.points[0] - Point{10, 2, 6}) < 1e-12);
  CHECK(cloud.points[1] == Point{1, 0, 3});
}

TEST_CASE("sparse data of a glTF binary replace items, of others or of zeros, or are refused") {
  const std::string start = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 52}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 4},
      {"buffer": 0, "byteOffset": 40, "byteLength": 12}], "accessors": [{)";
  const std::string end = R"("componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 1,
      "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 2}}}]})";
  const auto with_id = [](std::uint16_t id) {
    return bytes_of_all<float>({1, 2, 3, 4, 5, 6, 7, 8, 9}) + bytes_of_all<std::uint16_t>({id, 0}) +
           bytes_of_all<float>({-1, -2, -3});
  };
  CHECK(read_bytes("a.glb", glb(start + "\"bufferView\": 0, " + end, with_id(1))).points ==
        std::vector<Point>{{1, 2, 3}, {-1, -2, -3}, {7, 8, 9}});
  CHECK(read_bytes("a.glb", glb(start + end, with_id(2))).points ==
        std::vector<Point>{{0, 0, 0}, {0, 0, 0}, {-1, -2, -3}});
  CHECK(contains(complaint("a.glb", glb(start + end, with_id(3))),
                 "sparse data for an item that is not there"));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string json = start + end;
    json.replace(json.find(from), from.size(), to);
    return complaint("a.glb", glb(json, with_id(1)));
  };
  CHECK(contains(changed("\"count\": 3", "\"count\": 4294967295"), "more data than a file of its size"));
  CHECK(contains(changed("{\"count\": 1", "{\"count\": 2"), "outside of its buffer"));
  CHECK(
      contains(changed("\"values\": {\"bufferView\": 2}", "\"values\": 7"), "bufferViews that is not there"));
  CHECK(contains(changed("\"indices\"", "\"indexes\""), "type that glTF does not know"));
}

TEST_CASE("a glTF binary that is wrong is refused") {
  const std::string good = "{" + views + "}", place = bytes_of_all<float>({1, 2, 3});
  CHECK(read_bytes("a.glb", glb(good, place)).points == std::vector<Point>{{1, 2, 3}});
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string json = good;
    json.replace(json.find(from), from.size(), to);
    return complaint("a.glb", glb(json, place));
  };
  CHECK(contains(changed("\"count\": 1", "\"count\": 2"), "outside of its buffer"));
  CHECK(contains(changed("\"count\": 1", "\"count\": 4294967295"), "outside of its buffer"));
  CHECK(contains(changed("\"count\": 1", "\"count\": -1"), "no count"));
  CHECK(contains(changed("\"POSITION\": 0", "\"POSITION\": 1"), "accessors that is not there"));
  CHECK(
      contains(changed("\"byteLength\": 12}], \"buffers\"", "\"byteLength\": 99}], \"buffers\""), "outside"));
  CHECK(contains(changed("5126", "5127"), "type that glTF does not know"));
  CHECK(contains(changed("\"bufferView\": 0, ", ""), "without a place in the file"));
  CHECK(contains(changed("{\"byteLength\"", "{\"uri\": \"a.bin\", \"byteLength\""), "another file"));
  CHECK(contains(changed("\"asset\"", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"asset\""),
                 "draco"));
  CHECK(contains(
      changed("\"asset\"", "\"nodes\": [{\"children\": [0]}], \"scenes\": [{\"nodes\": [0]}], \"asset\""),
      "hold each other"));
  CHECK(contains(complaint("a.glb", "glTF"), "no glTF binary"));
  CHECK(contains(complaint("a.glb", glb("{", place)), "not valid"));
}

}  // namespace
}  // namespace rimline
