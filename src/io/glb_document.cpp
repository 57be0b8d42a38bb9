// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/glb_document.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rimline::io {
namespace {

using Json = nlohmann::json;

constexpr GlbMatrix identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr int deepest_node = 64;
constexpr std::size_t most_nodes = 1000000;

GlbMatrix product(const GlbMatrix& a, const GlbMatrix& b) {
  GlbMatrix result{};
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    }
  }
  return result;
}

template <std::size_t count>
std::array<double, count> numbers(const Json& object, const char* key, std::array<double, count> otherwise) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != count) return otherwise;
  for (std::size_t i = 0; i < count; ++i) {
    if ((*found)[i].is_number()) otherwise[i] = (*found)[i].template get<double>();
  }
  return otherwise;
}

// Translation times rotation (a quaternion x y z w) times scale, or the matrix.
GlbMatrix matrix_of(const Json& node) {
  if (node.contains("matrix")) return numbers<16>(node, "matrix", identity);
  const auto t = numbers<3>(node, "translation", {0, 0, 0});
  const auto s = numbers<3>(node, "scale", {1, 1, 1});
  const auto [x, y, z, w] = numbers<4>(node, "rotation", {0, 0, 0, 1});
  return {s[0] * (1 - 2 * (y * y + z * z)),
          s[0] * 2 * (x * y + z * w),
          s[0] * 2 * (x * z - y * w),
          0,
          s[1] * 2 * (x * y - z * w),
          s[1] * (1 - 2 * (x * x + z * z)),
          s[1] * 2 * (y * z + x * w),
          0,
          s[2] * 2 * (x * z + y * w),
          s[2] * 2 * (y * z - x * w),
          s[2] * (1 - 2 * (x * x + y * y)),
          0,
          t[0],
          t[1],
          t[2],
          1};
}

std::uint32_t little_32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

std::size_t width_of(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  return type == "VEC4" ? 4 : 0;
}

}  // namespace

const char* GlbAccessor::place(std::size_t item) const {
  const auto found = std::lower_bound(replaced.begin(), replaced.end(), item);
  if (found == replaced.end() || *found != item) return first == nullptr ? nullptr : first + item * stride;
  return replacements + static_cast<std::size_t>(found - replaced.begin()) * width * size_in_bytes(type);
}

double GlbAccessor::value(std::size_t item, std::size_t number) const {
  const std::size_t size = size_in_bytes(type);
  const char* at = place(item);
  if (at == nullptr) return 0;
  const Field field{"", type, at + number * size, size};
  double result = 0;
  values_of_field(field, 1, std::endian::native == std::endian::big, &result, 1);
  if (!normalized || type == FieldType::Float32) return result;
  const bool is_signed = type == FieldType::Int8 || type == FieldType::Int16;
  const double most = static_cast<double>((1u << (8 * size - (is_signed ? 1 : 0))) - 1);
  return std::max(result / most, -1.0);
}

GlbDocument::GlbDocument(const Source& source) : source_(source) {
  constexpr std::uint32_t json_chunk = 0x4e4f534a, buffer_chunk = 0x004e4942;
  const std::string_view bytes = source.bytes();
  if (bytes.size() < 20 || little_32(bytes, 4) != 2 || little_32(bytes, 16) != json_chunk) {
    fail("is no glTF binary of version 2");
  }
  const std::size_t json_size = little_32(bytes, 12), after = 20 + json_size;
  if (bytes.size() < after) fail("ends within its JSON; the file is truncated");
  json_ = Json::parse(bytes.substr(20, json_size), nullptr, false);
  if (!json_.is_object())
    fail("holds JSON that is not valid, in the bytes from 20 to " + std::to_string(after));
  if (bytes.size() >= after + 8 && little_32(bytes, after + 4) == buffer_chunk) {
    if (bytes.size() - after - 8 < little_32(bytes, after))
      fail("ends within its buffer; the file is truncated");
    buffer_ = bytes.substr(after + 8, little_32(bytes, after));
  }
  for (const Json& extension : json_.value("extensionsRequired", Json::array())) {
    if (extension != "KHR_mesh_quantization" && extension.is_string() &&
        extension.get<std::string>().find("compression") != std::string::npos) {
      fail("needs " + io::quoted(extension.get<std::string>()) + ", which is not read");
    }
  }
}

void GlbDocument::fail(const std::string& message) const {
  source_.fail(message + "; export it again, without compression and as one file");
}

std::size_t GlbDocument::whole(const Json& object, const char* key, std::size_t otherwise) const {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 0xffffffffu)
    fail("has a " + io::quoted(key) + " that is no count");
  return found->get<std::size_t>();
}

const Json& GlbDocument::entry(const char* list, const Json& number) const {
  const auto found = json_.find(list);
  const bool good = found != json_.end() && found->is_array() && number.is_number_unsigned() &&
                    number.get<std::uint64_t>() < found->size() &&
                    (*found)[number.get<std::size_t>()].is_object();
  if (!good) fail(std::string("names one of its ") + list + " that is not there");
  return (*found)[number.get<std::size_t>()];
}

FieldType GlbDocument::type_of(const Json& part) const {
  switch (whole(part, "componentType", 0)) {
    case 5120: return FieldType::Int8;
    case 5121: return FieldType::UInt8;
    case 5122: return FieldType::Int16;
    case 5123: return FieldType::UInt16;
    case 5125: return FieldType::UInt32;
    case 5126: return FieldType::Float32;
    default: fail("has data of a type that glTF does not know");
  }
}

// Where `count` items of so many bytes begin; sets the step between them. `part` names a view and an offset
// in it.
const char* GlbDocument::data_of(const Json& part, std::size_t item, std::size_t count,
                                 std::size_t& stride) const {
  const Json& view = entry("bufferViews", part.value("bufferView", Json()));
  if (whole(view, "buffer", 1) != 0 || entry("buffers", 0u).contains("uri"))
    fail("keeps its data in another file");
  const std::size_t begin = whole(view, "byteOffset", 0), size = whole(view, "byteLength", 0);
  const std::size_t offset = whole(part, "byteOffset", 0);
  stride = whole(view, "byteStride", item);
  const std::size_t used = count == 0 ? 0 : (count - 1) * stride + item;
  if (begin > buffer_.size() || size > buffer_.size() - begin || offset > size || used > size - offset ||
      stride < item) {
    fail("has data that lie outside of its buffer");
  }
  return buffer_.data() + begin + offset;
}

void GlbDocument::read_sparse(const Json& sparse, GlbAccessor& accessor) const {
  const Json none = Json::object();
  const auto part = [&](const char* key) -> const Json& {
    const auto found = sparse.is_object() ? sparse.find(key) : sparse.end();
    return found != sparse.end() && found->is_object() ? *found : none;
  };
  const std::size_t count = sparse.is_object() ? whole(sparse, "count", 0) : 0;
  GlbAccessor ids{.type = type_of(part("indices")), .count = count};
  ids.first = data_of(part("indices"), size_in_bytes(ids.type), count, ids.stride);
  std::size_t stride = 0;
  accessor.replacements =
      data_of(part("values"), accessor.width * size_in_bytes(accessor.type), count, stride);
  for (std::size_t i = 0; i < count; ++i) {
    const double id = ids.value(i, 0);
    const bool ascends = accessor.replaced.empty() || id > accessor.replaced.back();
    if (!ascends || !(id >= 0 && id < static_cast<double>(accessor.count)))
      fail("has sparse data for an item that is not there, or not in order");
    accessor.replaced.push_back(static_cast<std::uint32_t>(id));
  }
}

GlbAccessor GlbDocument::accessor(const Json& number) const {
  const Json& json = entry("accessors", number);
  GlbAccessor result;
  result.type = type_of(json);
  const auto type = json.find("type");
  result.width = type != json.end() && type->is_string() ? width_of(type->get<std::string>()) : 0;
  if (result.width == 0) fail("has data of a shape that is not read");
  const auto normalized = json.find("normalized");
  result.normalized = normalized != json.end() && *normalized == true;
  result.count = whole(json, "count", 0);
  const auto sparse = json.find("sparse");
  if (json.contains("bufferView")) {
    result.first = data_of(json, result.width * size_in_bytes(result.type), result.count, result.stride);
  } else if (sparse == json.end()) {
    fail("has data without a place in the file");
  } else if (result.count > 64 * source_.bytes().size()) {  // zeros that the file has not
    fail("announces more data than a file of its size has");
  }
  if (sparse != json.end()) read_sparse(*sparse, result);
  return result;
}

void GlbDocument::visit_mesh(std::size_t mesh, const GlbMatrix& place, const Visit& visit) const {
  const auto primitives = entry("meshes", mesh).find("primitives");
  if (primitives == entry("meshes", mesh).end() || !primitives->is_array()) return;
  for (const Json& primitive : *primitives) {
    if (primitive.is_object() && primitive.contains("attributes")) visit(primitive, place);
  }
}

void GlbDocument::visit_node(std::size_t number, const GlbMatrix& above, int depth, const Visit& visit,
                             std::size_t& nodes_left) const {
  const Json& node = entry("nodes", number);
  if (depth > deepest_node || nodes_left-- == 0) fail("has nodes that hold each other");
  const GlbMatrix place = product(above, matrix_of(node));
  if (node.contains("mesh")) visit_mesh(whole(node, "mesh", 0), place, visit);
  const auto children = node.find("children");
  if (children == node.end() || !children->is_array()) return;
  for (const Json& child : *children) {
    if (!child.is_number_unsigned()) fail("has a node whose child is no number");
    visit_node(child.get<std::size_t>(), place, depth + 1, visit, nodes_left);
  }
}

void GlbDocument::visit_primitives(const Visit& visit) const {
  const auto scenes = json_.find("scenes");
  std::size_t nodes_left = most_nodes;
  if (scenes != json_.end() && scenes->is_array() && !scenes->empty()) {
    const auto nodes = entry("scenes", whole(json_, "scene", 0)).find("nodes");
    const Json none = Json::array();
    for (const Json& node : nodes == entry("scenes", whole(json_, "scene", 0)).end() ? none : *nodes) {
      if (!node.is_number_unsigned()) fail("has a scene whose node is no number");
      visit_node(node.get<std::size_t>(), identity, 0, visit, nodes_left);
    }
    return;
  }
  const std::size_t meshes = json_.contains("meshes") ? json_["meshes"].size() : 0;
  for (std::size_t mesh = 0; mesh < meshes; ++mesh) visit_mesh(mesh, identity, visit);
}

}  // namespace rimline::io
