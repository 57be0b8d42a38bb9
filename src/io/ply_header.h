// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/fields.h"

namespace rimline::io {

struct PlyProperty {
  std::string name;
  FieldType type = FieldType::Float32;
  bool list = false;
  FieldType count_type = FieldType::UInt8;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  std::size_t size_in_bytes() const;  // of one record without lists
};

struct PlyHeader {
  enum class Format { Ascii, BinaryLittle, BinaryBig };
  Format format = Format::Ascii;
  std::vector<PlyElement> elements;
  const char* body = nullptr;  // the first byte after the header
};

// Throws CannotRead with the line.
PlyHeader read_ply_header(const Source& source);

}  // namespace rimline::io
