// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/files.h"
#include "io/safe_file.h"

namespace rimline {
namespace {

namespace fs = std::filesystem;

Cloud square() {
  Cloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 1e-7}};
  return cloud;
}

const std::vector<Triangle> two = {{0, 1, 2}, {0, 2, 3}};

std::string mesh_bytes(const std::string& name, const Cloud& cloud) {
  const TemporaryDirectory directory;
  write_mesh(directory.file(name), cloud, two, {});
  CHECK(directory.names() == std::vector<std::string>{name});
  return content_of(directory.file(name));
}

TEST_CASE("an OFF mesh has the shortest text that reads back the same") {
  CHECK(mesh_bytes("m.off", square()) == "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0.1\n0 1 1e-07\n3 0 1 2\n3 0 2 3\n");
  Cloud floats = square();
  floats.coordinate_type = Scalar::Float32;
  floats.points[2].z = static_cast<double>(0.1f);
  CHECK(contains(mesh_bytes("m.off", floats), "\n1 1 0.1\n"));
  CHECK(read_bytes("m.off", mesh_bytes("m.off", square())).points == square().points);
}

TEST_CASE("an OBJ mesh has texture and normals with the numbers of the vertices") {
  Cloud cloud = square();
  const std::string bare = mesh_bytes("m.obj", cloud);
  CHECK(contains(bare, "v 1 1 0.1\n"));
  CHECK(contains(bare, "\nf 1//1 2//2 3//3\nf 1//1 3//3 4//4\n"));
  set_column(cloud, make_column("u", std::vector<double>{0, 1, 1, std::nan("")}));
  set_column(cloud, make_column("v", std::vector<double>{0, 0, 0.5, 1}));
  for (const char* axis : {"nx", "ny", "nz"})
    set_column(cloud, make_column(axis, std::vector<float>(4, 0.6f)));
  const std::string full = mesh_bytes("m.obj", cloud);
  CHECK(contains(full, "\nvt 1 0.5\nvt 0 1\nvn 0.6 0.6 0.6\n"));
  CHECK(contains(full, "\nf 1/1/1 2/2/2 3/3/3\n"));
  CHECK(read_bytes("m.obj", full).points == cloud.points);
}

TEST_CASE("an STL mesh is read back with the points of its triangles") {
  const std::string bytes = mesh_bytes("m.stl", square());
  CHECK(bytes.size() == 84 + 2 * 50);
  Cloud back = read_bytes("m.stl", bytes);
  REQUIRE(back.points.size() == 4);
  CHECK(back.points[2].z == static_cast<double>(0.1f));
}

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

// A sheet of 10 cm where maps put it, which 32 bits do not hold: the case of 780 corners left of 3,600.
Cloud far_sheet(int side) {
  Cloud cloud;
  for (int i = 0; i < side * side; ++i)
    cloud.points.push_back({500000.25 + 0.1 / side * (i % side), 5400000.75 + 0.1 / side * (i / side), 12.0});
  return cloud;
}

std::vector<Triangle> sheet_triangles(int side) {
  std::vector<Triangle> triangles;
  for (Index row = 0; row + 1 < side; ++row) {
    for (Index i = row * side; i + 1 < (row + 1) * side; ++i) {
      triangles.push_back({i, i + 1, i + side});
      triangles.push_back({i + 1, i + side + 1, i + side});
    }
  }
  return triangles;
}

TEST_CASE("an STL of large coordinates is written less an offset that is told, and keeps all corners") {
  const TemporaryDirectory directory;
  const Cloud cloud = far_sheet(60);
  const WrittenMesh written = write_mesh(directory.file("far.stl"), cloud, sheet_triangles(60), {});
  REQUIRE(written.notices.size() == 1);
  CHECK(written.offset == Point{500000.3, 5400000.8, 12});
  CHECK(contains(written.notices[0], "500000.3, 5400000.8 and 12 were taken off"));
  CHECK(contains(content_of(directory.file("far.stl")).substr(0, 80), ", add 500000.3 5400000.8 12 "));
  const Cloud back = read_cloud(directory.file("far.stl"), {});
  REQUIRE(back.points.size() == 3600);
  double furthest = 0;
  for (const Point& p : back.points) {
    double nearest = 1;
    for (const Point& q : cloud.points) nearest = std::min(nearest, norm(p + written.offset - q));
    furthest = std::max(furthest, nearest);
  }
  CHECK(furthest < 1e-8);
}

TEST_CASE("an STL of coordinates that floats hold has no offset") {
  const TemporaryDirectory directory;
  Cloud cloud = far_sheet(20);
  for (Point& p : cloud.points) p = p - Point{500000, 5400000, 0};
  const WrittenMesh written = write_mesh(directory.file("near.stl"), cloud, sheet_triangles(20), {});
  CHECK(written.offset == Point{});
  CHECK(written.notices.empty());
}

TEST_CASE("a point far from the mesh takes no digit from the mesh in STL and glTF binary") {
  const TemporaryDirectory directory;
  const Cloud cloud = far_sheet(20);
  Cloud both = cloud;
  both.points.push_back({1e30, 0, 0});
  both.points.push_back({0, -1e300, 0});
  const WrittenMesh alone = write_mesh(directory.file("alone.stl"), cloud, sheet_triangles(20), {});
  CHECK(write_mesh(directory.file("both.stl"), both, sheet_triangles(20), {}).offset == alone.offset);
  CHECK(content_of(directory.file("both.stl")) == content_of(directory.file("alone.stl")));
  write_mesh(directory.file("both.glb"), both, sheet_triangles(20), {});
  const Cloud back = read_cloud(directory.file("both.glb"), {});
  REQUIRE(back.points.size() == 402);
  for (int i = 0; i < 400; ++i) CHECK(norm(back.points[i] - cloud.points[i]) < 1e-6);
  CHECK(back.points[400].x == doctest::Approx(1e30));
  CHECK(norm(back.points[401] - cloud.points[0]) < 100);  // beyond all floats: in the middle
}

TEST_CASE("corners that 32 bits can not part are refused, and no file is left") {
  Cloud cloud;
  cloud.points = {{0, 0, 0}, {1e9, 0, 0}, {1e9 + 1, 0, 0}, {0, 1, 0}, {1e200, 0, 0}};
  for (const char* name : {"a.stl", "a.glb"}) {
    CAPTURE(name);
    const TemporaryDirectory directory;
    try {
      write_mesh(directory.file(name), cloud, {{0, 1, 2}, {0, 2, 3}}, {});
      FAIL_CHECK("was written");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::CannotWrite);
      CHECK(error.ids() == std::vector<Index>{1, 2});
      CHECK(contains(error.what(), directory.file(name) + ": "));
      CHECK(contains(error.what(), "32 bits"));
    }
    CHECK_THROWS_AS(write_mesh(directory.file(name), cloud, {{0, 3, 4}}, {}), Error);  // 1e200 is no float
    CHECK(directory.names().empty());
  }
}

TEST_CASE("colours go into OBJ and glTF, whatever their type") {
  const std::vector<Triangle> one = {{0, 1, 2}};
  for (int kind = 0; kind < 4; ++kind) {
    CAPTURE(kind);
    Cloud cloud;
    cloud.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (const char* name : {"red", "green", "blue"}) {
      if (kind == 0) cloud.columns.push_back(make_column(name, std::vector<std::uint8_t>{0, 51, 255}));
      if (kind == 1) cloud.columns.push_back(make_column(name, std::vector<std::uint16_t>{0, 13107, 65535}));
      if (kind == 2) cloud.columns.push_back(make_column(name, std::vector<float>{0, 0.2f, 1}));
      if (kind == 3) cloud.columns.push_back(make_column(name, std::vector<std::uint16_t>{0, 51, 255}));
    }
    const TemporaryDirectory directory;
    write_mesh(directory.file("a.obj"), cloud, one, {});
    CHECK(contains(content_of(directory.file("a.obj")), "v 1 0 0 0.2 0.2 0.2\nv 0 1 0 1 1 1\n"));
    write_mesh(directory.file("a.glb"), cloud, one, {});
    CHECK(values(read_cloud(directory.file("a.glb"), {}), "green") == std::vector<double>{0, 51, 255});
  }
}

TEST_CASE("a glTF binary keeps large coordinates by the translation of its node") {
  Cloud cloud;
  cloud.points = {
      {500000.001, 4e6, 10}, {500001.001, 4e6, 10}, {500001.001, 4e6 + 1, 10.5}, {std::nan(""), 0, 0}};
  set_column(cloud, make_column("u", std::vector<double>{0, 1, 1, std::nan("")}));
  set_column(cloud, make_column("v", std::vector<double>{0, 0, 0.25, 1}));
  for (const char* c : {"red", "green", "blue"})
    set_column(cloud, make_column(c, std::vector<std::uint8_t>{1, 2, 3, 4}));
  const TemporaryDirectory directory;
  write_mesh(directory.file("m.glb"), cloud, {{0, 1, 2}}, {});
  const std::string bytes = content_of(directory.file("m.glb"));
  CHECK(bytes.substr(0, 4) == "glTF");
  CHECK(number_at<std::uint32_t>(bytes, 4) == 2);
  CHECK(number_at<std::uint32_t>(bytes, 8) == bytes.size());
  const std::size_t json_size = number_at<std::uint32_t>(bytes, 12);
  const auto json = nlohmann::json::parse(bytes.substr(20, json_size));
  const std::size_t buffer = 20 + json_size + 8;
  CHECK(number_at<std::uint32_t>(bytes, 20 + json_size) == bytes.size() - buffer);
  CHECK(json["buffers"][0]["byteLength"] == bytes.size() - buffer);
  const auto translation = json["nodes"][0]["translation"].get<std::vector<double>>();
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto offset_of = [&](int accessor) {
    return buffer + json["bufferViews"][json["accessors"][accessor]["bufferView"].get<int>()]["byteOffset"]
                        .get<std::size_t>();
  };
  const std::size_t position = offset_of(primitive["attributes"]["POSITION"]);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(translation[0] + number_at<float>(bytes, position + 12 * i) - cloud.points[i].x) < 1e-6);
    CHECK(std::abs(translation[1] + number_at<float>(bytes, position + 12 * i + 4) - cloud.points[i].y) <
          1e-6);
  }
  CHECK(number_at<float>(bytes, position + 36) == 0);
  const std::size_t texture = offset_of(primitive["attributes"]["TEXCOORD_0"]);
  CHECK(number_at<float>(bytes, texture + 16) == 1);
  CHECK(number_at<float>(bytes, texture + 20) == 0.75f);
  const std::size_t normal = offset_of(primitive["attributes"]["NORMAL"]);
  const Point n{number_at<float>(bytes, normal), number_at<float>(bytes, normal + 4),
                number_at<float>(bytes, normal + 8)};
  CHECK(std::abs(norm(n) - 1) < 1e-6);
  CHECK(n.z > 0.8);
  CHECK(bytes.substr(offset_of(primitive["attributes"]["COLOR_0"]), 8) == "\x01\x01\x01\xff\x02\x02\x02\xff");
  const std::size_t indices = offset_of(primitive["indices"]);
  CHECK(number_at<std::uint32_t>(bytes, indices + 8) == 2);
  CHECK(indices + 12 == bytes.size());
}

// What the standard asks of a binary of triangles (sections 3.6, 3.7 and 4.4 of glTF 2.0).
void check_strictly(const std::string& bytes) {
  const std::size_t json_size = number_at<std::uint32_t>(bytes, 12), buffer = 28 + json_size;
  CHECK(json_size % 4 == 0);
  CHECK((bytes.size() - buffer) % 4 == 0);
  CHECK(bytes.substr(16, 4) == "JSON");
  CHECK(bytes.substr(24 + json_size, 4) == std::string("BIN\0", 4));
  const auto json = nlohmann::json::parse(bytes.substr(20, json_size));
  CHECK(json["asset"]["version"] == "2.0");
  const auto& primitive = json["meshes"][0]["primitives"][0];
  CHECK(primitive["material"].get<std::size_t>() < json["materials"].size());
  const std::size_t vertices =
      json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()]["count"];
  for (const auto& accessor : json["accessors"]) {
    const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t offset = view["byteOffset"], length = view["byteLength"], count = accessor["count"];
    const std::string type = accessor["type"];
    const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.at(3) - '0');
    const int component = accessor["componentType"];
    const std::size_t size = component == 5121 ? 1 : 4;  // bytes; else floats (5126) or uints (5125)
    CHECK(offset % size == 0);
    CHECK(length == count * width * size);
    CHECK(buffer + offset + length <= bytes.size());
    const bool indices = component == 5125;
    CHECK(view["target"] == (indices ? 34963 : 34962));
    CHECK((indices || count == vertices));
    for (std::size_t i = 0; i < count * width; ++i) {
      const std::size_t at = buffer + offset + i * size;
      if (component == 5125) CHECK(number_at<std::uint32_t>(bytes, at) < vertices);
      if (component != 5126) continue;
      const float value = number_at<float>(bytes, at);
      CHECK(std::isfinite(value));
      if (!accessor.contains("min")) continue;
      CHECK(value >= accessor["min"][i % width].get<float>());
      CHECK(value <= accessor["max"][i % width].get<float>());
    }
  }
}

TEST_CASE("a glTF binary holds what the standard asks for, with points of no place, no uv and no triangle") {
  Cloud cloud = square();
  cloud.points[1] = {1e7, -3, 0.1};
  cloud.points.push_back({std::nan(""), 0, 0});
  check_strictly(mesh_bytes("m.glb", cloud));
  set_column(cloud, make_column("u", std::vector<double>{0, 1, 1, 0, std::nan("")}));
  set_column(cloud, make_column("v", std::vector<double>{0, 0, 0.5, 1, std::nan("")}));
  for (const char* c : {"red", "green", "blue"})
    set_column(cloud, make_column(c, std::vector<std::uint8_t>{1, 2, 3, 4, 5}));
  check_strictly(mesh_bytes("m.glb", cloud));
}

TEST_CASE("an OBJ and an OFF mesh have finite numbers only, and no vertex less for it") {
  Cloud cloud = square();
  cloud.points[0] = {std::nan(""), 0, 0};
  cloud.points.push_back({0, std::numeric_limits<double>::infinity(), 0});
  cloud.points.push_back({7, 8, 9});
  set_column(cloud, make_column("u", std::vector<double>(6, std::nan(""))));
  set_column(cloud, make_column("v", std::vector<double>(6, std::nan(""))));
  const TemporaryDirectory directory;
  for (const char* name : {"m.obj", "m.off"}) {
    CAPTURE(name);
    write_mesh(directory.file(name), cloud, {{1, 2, 3}}, {});
    const std::string text = content_of(directory.file(name));
    CHECK_FALSE(contains(text, "nan"));
    CHECK_FALSE(contains(text, "inf"));
    const std::vector<Point> points = read_bytes(name, text).points;
    REQUIRE(points.size() == 6);
    CHECK(points[0] == Point{1, 0, 0});  // of the first point that has a place
    CHECK(points[4] == Point{1, 0, 0});
    CHECK(points[5] == Point{7, 8, 9});
  }
}

TEST_CASE("an unknown ending of a mesh is a bad option") {
  CHECK_NOTHROW(check_mesh_path("-"));
  CHECK_NOTHROW(check_mesh_path("a.b/C.PLY"));
  for (const char* path : {"mesh.xyz", "mesh", "a.ply/mesh"}) CHECK_THROWS_AS(check_mesh_path(path), Error);
}

std::string write_complaint(const std::string& path) {
  try {
    write_cloud(path, square(), {});
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::CannotWrite);
    return error.what();
  }
  return {};
}

TEST_CASE("what can not be written is named with the reason") {
  const TemporaryDirectory directory;
  CHECK(contains(write_complaint(directory.file("no/such/a.ply")), "no/such' does not exist"));
  CHECK(contains(write_complaint(directory.file("")), "Is a directory"));
  CHECK(directory.names().empty());
  if (fs::exists("/dev/full")) CHECK(contains(write_complaint("/dev/full"), "No space left on device"));
}

TEST_CASE("a handler that ends the process removes what is being written, and no file that is whole") {
  const TemporaryDirectory directory;
  write_text(directory.file("whole.txt"), "done");
  {
    io::SafeFile cut(directory.file("cut.txt"));
    cut.write("half of it");
    CHECK(directory.names().size() == 2);
    remove_unfinished_files();
    CHECK(directory.names() == std::vector<std::string>{"whole.txt"});
  }
  remove_unfinished_files();
  CHECK(directory.names() == std::vector<std::string>{"whole.txt"});
}

TEST_CASE("a cancelled write leaves the old file and nothing beside it") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.ply", "old");
  Cloud cloud;
  cloud.points.resize(300000);
  std::atomic<bool> stop = false;
  Run run;
  run.stop = &stop;
  std::size_t names_during = 0;
  run.on_progress = [&](Progress progress) {
    names_during = std::max(names_during, directory.names().size());
    if (progress.done > 0) stop = true;
  };
  CHECK_THROWS_AS(write_cloud(path, cloud, run), Error);
  CHECK(names_during == 2);
  CHECK(directory.names() == std::vector<std::string>{"a.ply"});
  CHECK(content_of(path) == "old");
}

TEST_CASE("a file is replaced through its link and keeps its permissions") {
  const TemporaryDirectory directory;
  const std::string target = directory.file("target.txt", "old");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(target, directory.file("link.txt"));
  write_text(directory.file("link.txt"), "new");
  CHECK(fs::is_symlink(directory.file("link.txt")));
  CHECK(content_of(target) == "new");
  CHECK(fs::status(target).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

}  // namespace
}  // namespace rimline
