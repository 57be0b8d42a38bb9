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
constexpr int code_clamp = 33071;

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
  // A picture is written last, because its size may be odd.
  void add_image(std::size_t bytes) {
    image_ = static_cast<int>(views_.size());
    views_.push_back({{"buffer", 0}, {"byteOffset", size_}, {"byteLength", bytes}});
    size_ += (bytes + 3) / 4 * 4;
  }
  Json& accessor(int number) { return accessors_[static_cast<std::size_t>(number)]; }
  std::size_t size() const { return size_; }

  // `about`: extra data that the standard has no field for.
  std::string text(const Json& primitive, Point translation, const Json& about) const {
    Json json = {{"asset", {{"version", "2.0"}, {"generator", "rimline"}, {"extras", about}}}, {"scene", 0}};
    json["scenes"] = Json::array({{{"nodes", {0}}}});
    json["nodes"] =
        Json::array({{{"mesh", 0}, {"translation", {translation.x, translation.y, translation.z}}}});
    json["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
    // An open surface is seen from both sides, and is no metal, as it would be by default.
    Json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"doubleSided", true}};
    if (image_ != no_image) {
      material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
      json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}});
      json["samplers"] = Json::array({{{"wrapS", code_clamp}, {"wrapT", code_clamp}}});
      json["images"] = Json::array({{{"bufferView", image_}, {"mimeType", "image/png"}}});
    }
    json["materials"] = Json::array({material});
    json["accessors"] = accessors_;
    json["bufferViews"] = views_;
    json["buffers"] = Json::array({{{"byteLength", size_}}});
    std::string result = json.dump();
    result.resize((result.size() + 3) / 4 * 4, ' ');
    return result;
  }

 private:
  static constexpr int no_image = -1;

  Json views_ = Json::array(), accessors_ = Json::array();
  std::size_t size_ = 0;
  int image_ = no_image;
};

// The attributes of the vertices: one for each point, then one for each position on a seam.
struct Attributes {
  Points points;
  const Seams& seams;
  Point middle;
  std::vector<Point> normals;
  const Column *u = nullptr, *v = nullptr;
  std::optional<Colours> colours;

  bool has_uv() const { return u != nullptr && v != nullptr; }
  std::size_t vertices() const { return points.size() + seams.point.size(); }
  Index point(std::size_t vertex) const {
    return vertex < points.size() ? static_cast<Index>(vertex) : seams.point[vertex - points.size()];
  }
  UV uv(std::size_t vertex) const {
    if (vertex >= points.size()) return seams.uv[vertex - points.size()];
    return {u->value(static_cast<Index>(vertex)), v->value(static_cast<Index>(vertex))};
  }
};

// Unused points may have no place, or one that no float holds; the standard allows neither.
Point local_place(const Attributes& a, std::size_t vertex) {
  const Point place = a.points[a.point(vertex)] - a.middle;
  return floats_hold(place) ? place : Point{};
}

// The ids of the points as the standard wants attributes of our own: floats, which hold 24 bits.
constexpr Index float_ids = Index{1} << 24;
bool has_large_ids(const Attributes& a) { return a.points.size() > static_cast<std::size_t>(float_ids); }

Point unit_normal(Point normal) {
  const double length = norm(normal);
  return length > 0 && std::isfinite(length) ? (1 / length) * normal : Point{0, 0, 1};
}

float finite_float(double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0f; }

Json json_of(Point p) {  // exactly what is written, as the standard asks for
  return Json::array({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
}

Attributes attributes_of(const MeshToWrite& mesh, const Box& box) {
  const auto& [cloud, triangles, ignored, dress, path] = mesh;
  Attributes a{.points = cloud.points, .seams = dress.seams, .middle = {}, .normals = {}, .colours = {}};
  a.middle = box.empty() ? Point{} : 0.5 * (box.low + box.high);
  a.normals = cloud.normals();
  if (a.normals.empty()) a.normals = normals_of_mesh(cloud.points, triangles);
  a.u = cloud.find("u"), a.v = cloud.find("v");
  if (dress.picture.empty()) a.colours = colours_of(cloud);  // they would be multiplied with the picture's
  return a;
}

Json describe(Document& document, const Attributes& a, const Triangles& triangles) {
  const std::size_t count = a.vertices();
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
  if (a.has_uv()) {
    const bool large = has_large_ids(a);
    attributes["_POINT"] =
        document.add(count, large ? "VEC2" : "SCALAR", code_float, large ? 8 : 4, target_vertices);
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

void write_colour(SafeFile& file, const Colours& colours, Index point) {
  for (std::size_t c = 0; c < 3; ++c) file.write(static_cast<char>(colours.byte(point, c)));
  file.write('\xff');  // opaque; alpha is here to fill four bytes
}

void write_id(SafeFile& file, Index point, bool large) {
  file.little(static_cast<float>(point % float_ids));
  if (large) file.little(static_cast<float>(point / float_ids));
}

void write_buffer(SafeFile& file, const Attributes& a, const MeshToWrite& mesh, const Run& run) {
  const std::size_t count = a.vertices();
  for_each_written(count, run, [&](std::size_t i) { write_three(file, local_place(a, i)); });
  for_each_written(count, run, [&](std::size_t i) { write_three(file, unit_normal(a.normals[a.point(i)])); });
  if (a.has_uv()) {
    for_each_written(count, run, [&](std::size_t i) {
      const UV at = a.uv(i);
      file.little(finite_float(at.u));
      file.little(finite_float(1 - at.v));  // the standard's v points down
    });
  }
  if (a.colours)
    for_each_written(count, run, [&](std::size_t i) { write_colour(file, *a.colours, a.point(i)); });
  if (a.has_uv())
    for_each_written(count, run, [&](std::size_t i) { write_id(file, a.point(i), has_large_ids(a)); });
  for_each_written(mesh.triangles.size(), run, [&](std::size_t t) {
    for (const Index id : mesh.corners(t)) file.little(static_cast<std::uint32_t>(id));
  });
  std::string picture = mesh.dress.picture;
  picture.resize((picture.size() + 3) / 4 * 4, '\0');
  file.write(picture);
}

// The standard has metres and y up; what comes in has its own.
Json about(const Cloud& cloud) {
  return {{"unit", cloud.unit.empty() ? "that of the input" : cloud.unit},
          {"axes", "x, y and z of the input; not turned to y up"}};
}

}  // namespace

Point write_glb(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const Attributes attributes = attributes_of(mesh, box_of_corners(mesh));
  Document document;
  check_floats(mesh, attributes.middle, file.name() + ": glTF binary");
  const Json primitive = describe(document, attributes, mesh.triangles);
  if (!mesh.dress.picture.empty()) document.add_image(mesh.dress.picture.size());
  const std::string json = document.text(primitive, attributes.middle, about(mesh.cloud));
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
  write_buffer(file, attributes, mesh, run);
  return {};  // the offset is in the file, as the node's translation
}

}  // namespace rimline::io
