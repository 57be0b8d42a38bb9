// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a PLY: lists of the element `face` that name vertices.
#include <bit>

#include "io/lines.h"
#include "io/ply_header.h"
#include "io/readers.h"

namespace rimline::io {
namespace {

bool names_corners(const PlyElement& element, const PlyProperty& property) {
  return element.name == "face" && property.list && property.name.starts_with("vertex_ind");
}

void read_ascii_record(Row& row, const PlyElement& element, Faces& faces, const Source& source) {
  for (const PlyProperty& property : element.properties) {
    std::uint64_t count = 1;
    if (property.list && !row.read(count)) source.fail_at_line(row.at(), "a list without its length");
    for (std::uint64_t i = 0; i < count; ++i) {
      if (row.done()) source.fail_at_line(row.at(), "a line that is too short");
      if (!names_corners(element, property)) {
        row.word();
        continue;
      }
      long long id = 0;
      const char* at = row.at();
      if (!row.read(id)) source.fail_at_line(row.at(), quoted(row.rest()) + " is no id of a vertex");
      faces.corner(id, at, Faces::Place::Line);
    }
    if (names_corners(element, property)) faces.close();
  }
}

void read_ascii_faces(const PlyHeader& header, Faces& faces, const Source& source) {
  Lines lines({header.body, source.bytes_from(header.body)});
  std::string_view line;
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!lines.next_filled(line)) source.fail("ends within element " + quoted(element.name));
      if (element.name != "face") continue;
      Row row(line);
      read_ascii_record(row, element, faces, source);
    }
  }
}

// An integer of a PLY type, with its sign.
long long integer_at(const char* at, FieldType type, bool swap) {
  const std::size_t size = size_in_bytes(type);
  std::uint64_t bits = 0;
  const bool little = (std::endian::native == std::endian::little) != swap;
  for (std::size_t i = 0; i < size; ++i)
    bits |= std::uint64_t{static_cast<unsigned char>(at[i])} << (8 * (little ? i : size - 1 - i));
  const bool is_signed = type == FieldType::Int8 || type == FieldType::Int16 || type == FieldType::Int32 ||
                         type == FieldType::Int64;
  if (is_signed && size < 8 && (bits >> (8 * size - 1)) != 0) bits |= ~std::uint64_t{0} << (8 * size);
  return static_cast<long long>(bits);
}

void read_binary_faces(const PlyHeader& header, Faces& faces, const Source& source) {
  const bool swap =
      (header.format == PlyHeader::Format::BinaryBig) != (std::endian::native == std::endian::big);
  const char* at = header.body;
  const auto take = [&](std::size_t bytes) {
    if (source.bytes_from(at) < bytes) source.fail("ends within its elements; the file is truncated");
    const char* here = at;
    at += bytes;
    return here;
  };
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;  // no bytes, however many records the header tells
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        const std::size_t size = size_in_bytes(property.type);
        long long count = 1;
        if (property.list)
          count = integer_at(take(size_in_bytes(property.count_type)), property.count_type, swap);
        if (count < 0 || static_cast<std::uint64_t>(count) > source.bytes_from(at) / size)
          source.fail_at_byte(at, "a list longer than the file");
        const char* values = take(static_cast<std::size_t>(count) * size);
        if (!names_corners(element, property)) continue;
        for (long long k = 0; k < count; ++k) {
          const char* value = values + static_cast<std::size_t>(k) * size;
          faces.corner(integer_at(value, property.type, swap), value, Faces::Place::Byte);
        }
        faces.close();
      }
    }
  }
}

}  // namespace

void read_ply_faces(const Source& source, const Cloud&, Faces& faces) {
  const PlyHeader header = read_ply_header(source);
  header.format == PlyHeader::Format::Ascii ? read_ascii_faces(header, faces, source)
                                            : read_binary_faces(header, faces, source);
}

}  // namespace rimline::io
