// SPDX-License-Identifier: GPL-3.0-or-later
// The checked content of a glTF 2.0 binary: its JSON, its buffer, and the primitives of its scene.
#pragma once

#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/fields.h"

namespace rimline::io {

// Columns of a matrix of four by four, as glTF has them.
using GlbMatrix = std::array<double, 16>;

// One accessor: `width` numbers an item.
struct GlbAccessor {
  FieldType type = FieldType::Float32;
  std::size_t count = 0, width = 1, stride = 0;
  bool normalized = false;
  const char* first = nullptr;  // none where all items are zero but those that are replaced
  // Sparse data: the items that have other values, ascending, and where these begin.
  std::vector<std::uint32_t> replaced = {};
  const char* replacements = nullptr;

  double value(std::size_t item, std::size_t number) const;
  // The position of an item; none where it is zero.
  const char* place(std::size_t item) const;
};

class GlbDocument {
 public:
  // Throws CannotRead, also for compressed geometry and data outside of the file.
  explicit GlbDocument(const Source& source);

  using Visit = std::function<void(const nlohmann::json& primitive, const GlbMatrix& place)>;
  // Calls visit for each primitive of the scene (or of all meshes, where there is no scene), in order.
  void visit_primitives(const Visit& visit) const;

  // The accessor of that number in a primitive's description.
  GlbAccessor accessor(const nlohmann::json& number) const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  void visit_node(std::size_t node, const GlbMatrix& above, int depth, const Visit& visit,
                  std::size_t& nodes_left) const;
  void visit_mesh(std::size_t mesh, const GlbMatrix& place, const Visit& visit) const;
  FieldType type_of(const nlohmann::json& part) const;
  const char* data_of(const nlohmann::json& part, std::size_t item, std::size_t count,
                      std::size_t& stride) const;
  void read_sparse(const nlohmann::json& sparse, GlbAccessor& accessor) const;
  const nlohmann::json& entry(const char* list, const nlohmann::json& number) const;
  std::size_t whole(const nlohmann::json& object, const char* key, std::size_t otherwise) const;

  const Source& source_;
  nlohmann::json json_;
  std::string_view buffer_;
};

}  // namespace rimline::io
