// SPDX-License-Identifier: GPL-3.0-or-later
// PLY: Greg Turk's format, 1994. Only the element of the points is read; elements before it are stepped
// over, those after it are not looked at.
#include <algorithm>
#include <bit>

#include "io/ply_header.h"
#include "io/readers.h"

namespace rimline::io {
namespace {

using Format = PlyHeader::Format;

bool has_coordinates(const PlyElement& element) {
  const auto has = [&](std::string_view name) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) { return !p.list && p.name == name; });
  };
  return has("x") && has("y") && has("z");
}

// `vertex`, or else the first element that has x, y and z.
std::size_t find_points(const PlyHeader& header, const Source& source) {
  const auto& elements = header.elements;
  auto found = std::find_if(elements.begin(), elements.end(), [](auto& e) { return e.name == "vertex"; });
  if (found == elements.end()) found = std::find_if(elements.begin(), elements.end(), has_coordinates);
  if (found == elements.end()) {
    source.fail("the PLY header declares no element 'vertex' with properties x, y, z");
  }
  return static_cast<std::size_t>(found - elements.begin());
}

[[noreturn]] void fail_truncated(const Source& source, const PlyElement& element) {
  source.fail(
      "ends at byte " + std::to_string(source.bytes().size()) + ", before the " +
      std::to_string(element.count) + " records of element " + quoted(element.name) +
      " that the header announces; the file is truncated or its count wrong: copy or export it again");
}

// The number of items of a list; throws where it is negative or has no bytes left to stand in.
std::uint64_t list_count(const char* at, FieldType type, bool swap, const PlyElement& element,
                         const Source& source) {
  const std::size_t size = size_in_bytes(type);
  if (source.bytes_from(at) < size) fail_truncated(source, element);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const bool little = (std::endian::native == std::endian::little) != swap;
    value |= std::uint64_t{static_cast<unsigned char>(at[i])} << (8 * (little ? i : size - 1 - i));
  }
  const bool is_signed = type == FieldType::Int8 || type == FieldType::Int16 || type == FieldType::Int32 ||
                         type == FieldType::Int64;
  if (is_signed && (value >> (8 * size - 1)) != 0)
    source.fail_at_byte(at, "a list with a negative number of items");
  return value;
}

// Steps over one record with lists. Calls take(property, bytes) for what is not a list.
template <class Take>
const char* walk_record(const char* at, const PlyElement& element, bool swap, const Source& source,
                        const Take& take) {
  for (const PlyProperty& property : element.properties) {
    const std::size_t size = size_in_bytes(property.type);
    std::uint64_t count = 1;
    if (property.list) {
      count = list_count(at, property.count_type, swap, element, source);
      at += size_in_bytes(property.count_type);
    }
    if (source.bytes_from(at) / size < count) fail_truncated(source, element);
    if (!property.list) take(property, at);
    at += count * size;
  }
  return at;
}

const char* skip_binary(const char* at, const PlyElement& element, bool swap, const Source& source,
                        const Run& run) {
  if (!element.has_list()) {
    const std::size_t size = element.size_in_bytes();
    if (size == 0) return at;
    if (source.bytes_from(at) / size < element.count) fail_truncated(source, element);
    return at + element.count * size;
  }
  for (std::uint64_t i = 0; i < element.count; ++i) {
    if (i % items_per_look == 0) source.progress(run, at);
    at = walk_record(at, element, swap, source, [](const PlyProperty&, const char*) {});
  }
  return at;
}

std::vector<Field> fields_of(const PlyElement& element) {
  std::vector<Field> fields;
  for (const PlyProperty& p : element.properties) {
    if (!p.list) fields.push_back({p.name, p.type, nullptr, 0});
  }
  return fields;
}

// A count is used only after the file was checked to be large enough for it.
void check_room(const char* at, const PlyElement& element, std::size_t least_bytes, const Source& source) {
  check_point_count(source, element.count);
  if (least_bytes == 0 || source.bytes_from(at) / least_bytes < element.count)
    fail_truncated(source, element);
}

Cloud read_binary_points(const char* at, const PlyElement& element, bool swap, const Source& source,
                         const Run& run) {
  std::vector<Field> fields = fields_of(element);
  std::vector<char> packed;
  const char* records = at;
  check_room(at, element, std::max<std::size_t>(element.size_in_bytes(), 1), source);
  if (element.has_list()) {
    packed.reserve(element.count * element.size_in_bytes());
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % items_per_look == 0) source.progress(run, at);
      at = walk_record(at, element, swap, source, [&](const PlyProperty& p, const char* value) {
        packed.insert(packed.end(), value, value + size_in_bytes(p.type));
      });
    }
    records = packed.data();
  }
  lay_out(fields, records);
  return cloud_from_fields(fields, element.count, swap, source, run);
}

void skip_list(Row& row, const std::string& name, const Source& source) {
  std::uint64_t count = 0;
  if (!row.read(count))
    source.fail_at_line(row.at(), "list " + quoted(name) + " does not start with its length");
  for (; count > 0; --count) {
    if (row.done())
      source.fail_at_line(row.at(), "list " + quoted(name) + " is shorter than its length says");
    row.word();
  }
}

void read_ascii_record(Row& row, const PlyElement& element, char* to, const Source& source) {
  for (const PlyProperty& property : element.properties) {
    if (property.list) {
      skip_list(row, property.name, source);
      continue;
    }
    if (!read_value(row, property.type, to)) {
      source.fail_at_line(row.at(), row.done()
                                        ? "the value of property " + quoted(property.name) + " is missing"
                                        : quoted(Row(row).word()) + " is no value for property " +
                                              quoted(property.name) + " of the type in the header");
    }
    to += size_in_bytes(property.type);
  }
  if (!row.done()) {
    source.fail_at_line(row.at(), "more values than the header declares properties: " + quoted(row.rest()));
  }
}

Cloud read_ascii_points(Lines& lines, const PlyElement& element, const Source& source, const Run& run) {
  std::vector<Field> fields = fields_of(element);
  // A value takes at least a digit and a blank or line end, which the last line may lack.
  const std::size_t least = std::max<std::size_t>(2 * element.properties.size(), 2) - 1;
  check_room(lines.at(), element, least, source);
  const std::size_t record = lay_out(fields, nullptr);
  std::vector<char> packed(element.count * record);
  std::string_view line;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    if (i % items_per_look == 0) source.progress(run, lines.at());
    if (!lines.next_filled(line)) fail_truncated(source, element);
    Row row(line);
    read_ascii_record(row, element, packed.data() + i * record, source);
  }
  lay_out(fields, packed.data());
  return cloud_from_fields(fields, element.count, false, source, run);
}

Cloud read_ascii(const PlyHeader& header, std::size_t points, const Source& source, const Run& run) {
  Lines lines({header.body, source.bytes_from(header.body)});
  for (std::size_t e = 0; e < points; ++e) {
    std::string_view line;
    for (std::uint64_t i = 0; i < header.elements[e].count; ++i) {
      if (i % items_per_look == 0) source.progress(run, lines.at());
      if (!lines.next_filled(line)) fail_truncated(source, header.elements[e]);
    }
  }
  return read_ascii_points(lines, header.elements[points], source, run);
}

const char* name(Format format) {
  switch (format) {
    case Format::Ascii: return "PLY, ascii";
    case Format::BinaryLittle: return "PLY, binary little-endian";
    case Format::BinaryBig: return "PLY, binary big-endian";
  }
  return "PLY";
}

Cloud read_binary(const PlyHeader& header, std::size_t points, const Source& source, const Run& run) {
  const bool swap = (header.format == Format::BinaryBig) != (std::endian::native == std::endian::big);
  const char* at = header.body;
  for (std::size_t e = 0; e < points; ++e) at = skip_binary(at, header.elements[e], swap, source, run);
  return read_binary_points(at, header.elements[points], swap, source, run);
}

}  // namespace

Cloud read_ply(const Source& source, const Run& run) {
  const PlyHeader header = read_ply_header(source);
  const std::size_t points = find_points(header, source);
  Cloud cloud = header.format == Format::Ascii ? read_ascii(header, points, source, run)
                                               : read_binary(header, points, source, run);
  cloud.format = name(header.format);
  return cloud;
}

}  // namespace rimline::io
