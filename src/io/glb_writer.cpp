// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0 binary: a JSON chunk and one buffer. The standard knows floats only, so that the middle of the
// points goes into the node's translation and the vertices are what is left: small numbers, kept well.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/colours.h"
#include "io/float_places.h"

namespace rimline::io {
namespace {

using Json = nlohmann::ordered_json;

// Codes of the standard.
constexpr int code_ubyte = 5121, code_uint = 5125, code_float = 5126;
constexpr int target_vertices = 34962, target_indices = 34963;
constexpr int mode_points = 0, mode_triangles = 4;

// The buffer is described first and written after, view by view in the same order.
class Document {
 public:
  // Returns the number of the accessor of a new view.
  int add(std::size_t count, const char* type, int component, std::size_t item_bytes, int target) {
    const int view = static_cast<int>(views_.size());
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", size_}, {"byteLength", count * item_bytes}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    size_ += count * item_bytes;  // all items are of four bytes or a multiple: always aligned
    return view;
  }
  Json& accessor(int number) { return accessors_[static_cast<std::size_t>(number)]; }
  std::size_t size() const { return size_; }

  std::string text(const Json& primitive, Point translation) const {
    Json json = {{"asset", {{"version", "2.0"}, {"generator", "rimline"}}}, {"scene", 0}};
    json["scenes"] = Json::array({{{"nodes", {0}}}});
    json["nodes"] =
        Json::array({{{"mesh", 0}, {"translation", {translation.x, translation.y, translation.z}}}});
    json["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
    // An open surface is seen from both sides, and is no metal, as it would be by default.
    json["materials"] =
        Json::array({{{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"doubleSided", true}}});
    json["accessors"] = accessors_;
    json["bufferViews"] = views_;
    json["buffers"] = Json::array({{{"byteLength", size_}}});
    std::string result = json.dump();
    result.resize((result.size() + 3) / 4 * 4, ' ');
    return result;
  }

 private:
  Json views_ = Json::array(), accessors_ = Json::array();
  std::size_t size_ = 0;
};

// What the vertices carry.
struct Attributes {
  Points points;
  Point middle;
  std::vector<Point> normals;
  const Column *u = nullptr, *v = nullptr;
  std::optional<Colours> colours;

  bool has_uv() const { return u != nullptr && v != nullptr; }
};

// Unused points may have no place, or one that no float holds; the standard allows neither.
Point local_place(const Attributes& a, std::size_t i) {
  const Point place = a.points[i] - a.middle;
  return floats_hold(place) ? place : Point{};
}

Point unit_normal(Point normal) {
  const double length = norm(normal);
  return length > 0 && std::isfinite(length) ? (1 / length) * normal : Point{0, 0, 1};
}

float finite_float(double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0f; }

Json json_of(Point p) {  // exactly what is written, as the standard asks for
  return Json::array({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
}

Attributes attributes_of(const Cloud& cloud, const Triangles& triangles, const Box& box) {
  Attributes a;
  a.points = cloud.points;
  a.middle = box.empty() ? Point{} : 0.5 * (box.low + box.high);
  a.normals = cloud.normals();
  if (a.normals.empty()) a.normals = normals_of_mesh(cloud.points, triangles);
  a.u = cloud.find("u"), a.v = cloud.find("v");
  a.colours = colours_of(cloud);
  return a;
}

Json describe(Document& document, const Attributes& a, const Triangles& triangles) {
  const std::size_t count = a.points.size();
  Json attributes;
  const int position = document.add(count, "VEC3", code_float, 12, target_vertices);
  attributes["POSITION"] = position;
  Box written;
  for (std::size_t i = 0; i < count; ++i) written.add(local_place(a, i));
  document.accessor(position)["min"] = json_of(written.empty() ? Point{} : written.low);
  document.accessor(position)["max"] = json_of(written.empty() ? Point{} : written.high);
  attributes["NORMAL"] = document.add(count, "VEC3", code_float, 12, target_vertices);
  if (a.has_uv()) attributes["TEXCOORD_0"] = document.add(count, "VEC2", code_float, 8, target_vertices);
  if (a.colours) {
    const int colour = document.add(count, "VEC4", code_ubyte, 4, target_vertices);
    document.accessor(colour)["normalized"] = true;
    attributes["COLOR_0"] = colour;
  }
  Json primitive = {{"attributes", attributes},
                    {"mode", triangles.empty() ? mode_points : mode_triangles},
                    {"material", 0}};
  if (!triangles.empty()) {
    primitive["indices"] = document.add(3 * triangles.size(), "SCALAR", code_uint, 4, target_indices);
  }
  return primitive;
}

void write_three(SafeFile& file, Point p) {
  for (const double value : {p.x, p.y, p.z}) file.little(static_cast<float>(value));
}

void write_buffer(SafeFile& file, const Attributes& a, const Triangles& triangles, const Run& run) {
  const std::size_t count = a.points.size();
  for_each_written(count, run, [&](std::size_t i) { write_three(file, local_place(a, i)); });
  for_each_written(count, run, [&](std::size_t i) { write_three(file, unit_normal(a.normals[i])); });
  if (a.has_uv()) {
    for_each_written(count, run, [&](std::size_t i) {
      const auto id = static_cast<Index>(i);
      file.little(finite_float(a.u->value(id)));
      file.little(finite_float(1 - a.v->value(id)));  // the standard's v points down
    });
  }
  if (a.colours) {
    for_each_written(count, run, [&](std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c)
        file.write(static_cast<char>(a.colours->byte(static_cast<Index>(i), c)));
      file.write('\xff');  // opaque; alpha is here to fill four bytes
    });
  }
  for_each_written(triangles.size(), run, [&](std::size_t t) {
    for (const Index id : triangles[t]) file.little(static_cast<std::uint32_t>(id));
  });
}

}  // namespace

Point write_glb(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const auto& [cloud, triangles, ignored] = mesh;
  const Attributes attributes = attributes_of(cloud, triangles, box_of_corners(mesh));
  Document document;
  check_floats(mesh, attributes.middle, file.name() + ": glTF binary");
  const Json primitive = describe(document, attributes, triangles);
  const std::string json = document.text(primitive, attributes.middle);
  const std::size_t total = 12 + 8 + json.size() + 8 + document.size();
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::CannotWrite,
                file.name() + ": a glTF binary can not hold 4 GB or more; write PLY instead");
  }
  constexpr std::uint32_t version = 2, json_chunk = 0x4e4f534a, buffer_chunk = 0x004e4942;
  file.write("glTF");
  for (const auto number :
       {version, static_cast<std::uint32_t>(total), static_cast<std::uint32_t>(json.size()), json_chunk}) {
    file.little(number);
  }
  file.write(json);
  file.little(static_cast<std::uint32_t>(document.size()));
  file.little(buffer_chunk);
  write_buffer(file, attributes, triangles, run);
  return {};  // what is taken off is in the file, as the node's translation
}

}  // namespace rimline::io
