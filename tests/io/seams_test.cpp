// SPDX-License-Identifier: GPL-3.0-or-later
// uv of corners in files: two triangles of a square that are a chart each, so that both ends of their common
// edge have two places.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/files.h"

namespace rimline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<Triangle> two = {{0, 1, 2}, {0, 2, 3}};

Cloud square() {
  Cloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  set_column(cloud, make_column("u", std::vector<double>{nan, 1, nan, 2}));
  set_column(cloud, make_column("v", std::vector<double>{nan, 0, nan, 1}));
  return cloud;
}

// Places 4 and 5 are of point 0, 6 and 7 of point 2.
Dress two_charts() {
  return {.seams = {.uv = {{0, 0}, {2, 0}, {1, 1}, {3, 1}},
                    .point = {0, 0, 2, 2},
                    .corners = {{4, 1, 6}, {5, 7, 3}}}};
}

std::string bytes_of(const std::string& name, const Dress& dress) {
  const TemporaryDirectory directory;
  write_mesh(directory.file(name), square(), two, {}, {}, dress);
  return content_of(directory.file(name));
}

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

// The JSON of a glTF binary, and where its buffer starts.
nlohmann::json json_of(const std::string& bytes, std::size_t& buffer) {
  const std::size_t size = number_at<std::uint32_t>(bytes, 12);
  buffer = 20 + size + 8;
  return nlohmann::json::parse(bytes.substr(20, size));
}

std::size_t offset_of(const nlohmann::json& json, const nlohmann::json& accessor) {
  const int view = json["accessors"][accessor.get<int>()]["bufferView"];
  return json["bufferViews"][view]["byteOffset"];
}

}  // namespace

TEST_CASE("the place of a corner is its point's, or one of a seam") {
  const Dress dress = two_charts();
  const std::vector<UV> uv{{nan, nan}, {1, 0}, {nan, nan}, {2, 1}};
  CHECK(corner_uv(uv, dress.seams, two, 0, 0) == UV{0, 0});
  CHECK(corner_uv(uv, dress.seams, two, 0, 1) == UV{1, 0});
  CHECK(corner_uv(uv, dress.seams, two, 1, 0) == UV{2, 0});
  CHECK(corner_uv(uv, {}, two, 1, 2) == UV{2, 1});
}

TEST_CASE("PLY has a list texcoord of six numbers a face where there are seams, and none without") {
  const std::string bytes = bytes_of("m.ply", two_charts());
  CHECK(contains(bytes, "property list uchar int vertex_indices\nproperty list uchar double texcoord\n"));
  const std::size_t faces = bytes.size() - 2 * (13 + 49);
  const std::vector<std::vector<double>> wanted{{0, 0, 1, 0, 1, 1}, {2, 0, 3, 1, 2, 1}};
  for (std::size_t t = 0; t < 2; ++t) {
    const std::size_t at = faces + t * (13 + 49) + 13;
    CHECK(bytes[at] == 6);
    for (std::size_t i = 0; i < 6; ++i) CHECK(number_at<double>(bytes, at + 1 + 8 * i) == wanted[t][i]);
  }
  CHECK_FALSE(contains(bytes_of("m.ply", {}), "texcoord"));
}

TEST_CASE("OBJ numbers places apart from points") {
  const std::string bytes = bytes_of("m.obj", two_charts());
  CHECK(contains(bytes, "vt 0 0\nvt 1 0\nvt 0 0\nvt 2 1\nvt 0 0\nvt 2 0\nvt 1 1\nvt 3 1\n"));
  CHECK(contains(bytes, "f 1/5/1 2/2/2 3/7/3\nf 1/6/1 3/8/3 4/4/4\n"));
}

TEST_CASE("glTF has a vertex for each place, which carries the id of its point") {
  const std::string bytes = bytes_of("m.glb", two_charts());
  std::size_t buffer = 0;
  const auto json = json_of(bytes, buffer);
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto& attributes = primitive["attributes"];
  CHECK(json["accessors"][attributes["POSITION"].get<int>()]["count"] == 8);
  CHECK(json["asset"]["extras"]["unit"] == "that of the input");
  const std::size_t ids = buffer + offset_of(json, attributes["_POINT"]);
  const std::size_t places = buffer + offset_of(json, attributes["TEXCOORD_0"]);
  const std::size_t indices = buffer + offset_of(json, primitive["indices"]);
  const std::vector<std::array<float, 2>> wanted{{0, 0}, {1, 0}, {1, 1}, {2, 0}, {3, 1}, {2, 1}};
  const std::vector<float> points{0, 1, 2, 0, 2, 3};
  for (std::size_t corner = 0; corner < 6; ++corner) {
    const auto vertex = number_at<std::uint32_t>(bytes, indices + 4 * corner);
    CHECK(number_at<float>(bytes, ids + 4 * vertex) == points[corner]);
    CHECK(number_at<float>(bytes, places + 8 * vertex) == wanted[corner][0]);
    CHECK(number_at<float>(bytes, places + 8 * vertex + 4) == 1 - wanted[corner][1]);
  }
}

TEST_CASE("a picture lies beside an OBJ with its material, and within a glTF binary") {
  Dress dress = two_charts();
  dress.picture = "not quite a PNG";  // 15 bytes
  const TemporaryDirectory directory;
  write_mesh(directory.file("m.obj"), square(), two, {}, {}, dress);
  CHECK(content_of(directory.file("m.png")) == dress.picture);
  CHECK(contains(content_of(directory.file("m.mtl")), "map_Kd m.png\n"));
  CHECK(contains(content_of(directory.file("m.obj")), "mtllib m.mtl\n"));
  CHECK(contains(content_of(directory.file("m.obj")), "usemtl surface\nf "));
  const std::string bytes = bytes_of("m.glb", dress);
  std::size_t buffer = 0;
  const auto json = json_of(bytes, buffer);
  CHECK(json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 0);
  const auto& view = json["bufferViews"][json["images"][0]["bufferView"].get<int>()];
  CHECK(bytes.substr(buffer + view["byteOffset"].get<std::size_t>(), view["byteLength"]) == dress.picture);
  CHECK(bytes.size() % 4 == 0);
  CHECK(json["buffers"][0]["byteLength"] == bytes.size() - buffer);
}

}  // namespace rimline
