// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_header.h"

#include <algorithm>
#include <optional>

namespace rimline::io {
namespace {

// PLY's own names and those with a width, as most writers use today.
std::optional<FieldType> type_of(std::string_view name) {
  struct Alias {
    std::string_view name;
    FieldType type;
  };
  static constexpr Alias aliases[] = {
      {"char", FieldType::Int8},       {"int8", FieldType::Int8},       {"uchar", FieldType::UInt8},
      {"uint8", FieldType::UInt8},     {"short", FieldType::Int16},     {"int16", FieldType::Int16},
      {"ushort", FieldType::UInt16},   {"uint16", FieldType::UInt16},   {"int", FieldType::Int32},
      {"int32", FieldType::Int32},     {"uint", FieldType::UInt32},     {"uint32", FieldType::UInt32},
      {"float", FieldType::Float32},   {"float32", FieldType::Float32}, {"double", FieldType::Float64},
      {"float64", FieldType::Float64}, {"int64", FieldType::Int64},     {"uint64", FieldType::UInt64},
      {"float8", FieldType::Float64},
  };
  for (const Alias& alias : aliases) {
    if (alias.name == name) return alias.type;
  }
  return std::nullopt;
}

FieldType read_type(Row& row, const Source& source) {
  const char* at = row.at();
  const std::string_view word = row.word();
  if (const auto type = type_of(word)) return *type;
  source.fail_at_line(at, "unknown type " + quoted(word) +
                              "; PLY has char, uchar, short, ushort, int, uint, " + "float and double");
}

PlyHeader::Format read_format(Row& row, const Source& source) {
  const char* at = row.at();
  const std::string_view word = row.word();
  if (word == "ascii") return PlyHeader::Format::Ascii;
  if (word == "binary_little_endian") return PlyHeader::Format::BinaryLittle;
  if (word == "binary_big_endian") return PlyHeader::Format::BinaryBig;
  source.fail_at_line(at, "unknown PLY format " + quoted(word) +
                              "; known are ascii, binary_little_endian and binary_big_endian");
}

PlyElement read_element(Row& row, const Source& source) {
  PlyElement element;
  element.name = row.word();
  const char* at = row.at();
  if (!row.read(element.count)) {
    source.fail_at_line(at, "element " + quoted(element.name) + " has no count; write 'element NAME COUNT'");
  }
  return element;
}

PlyProperty read_property(Row& row, const Source& source) {
  PlyProperty property;
  Row copy = row;
  if (copy.word() == "list") {
    row = copy;
    property.list = true;
    property.count_type = read_type(row, source);
    if (property.count_type == FieldType::Float32 || property.count_type == FieldType::Float64) {
      source.fail_at_line(row.at(),
                          "a list can not have a fractional number of items; declare an integer type");
    }
  }
  property.type = read_type(row, source);
  property.name = row.word();
  if (property.name.empty()) source.fail_at_line(row.at(), "a property without a name");
  return property;
}

// The header ends lines as its first line does; what follows `end_header` is data, even if it looks like the
// second half of a line end.
std::string line_end(const Source& source) {
  const std::string_view start = source.bytes().substr(0, 64);
  const std::size_t at = start.find_first_of("\r\n");
  if (at == std::string_view::npos) source.fail("PLY header without line ends; save the file again");
  return std::string(start.substr(at, start.substr(at, 2) == "\r\n" ? 2 : 1));
}

class HeaderLines {
 public:
  explicit HeaderLines(const Source& source) : source_(source), end_(line_end(source)), at_(source.begin()) {}

  std::string_view next() {
    const std::string_view left(at_, source_.bytes_from(at_));
    const std::size_t stop = left.find(end_);
    if (stop == std::string_view::npos) {
      source_.fail("the PLY header has no 'end_header'; the file is truncated or not a PLY");
    }
    at_ += stop + end_.size();
    return trimmed(left.substr(0, stop));
  }

  const char* at() const { return at_; }

 private:
  const Source& source_;
  std::string end_;
  const char* at_;
};

}  // namespace

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.list; });
}

std::size_t PlyElement::size_in_bytes() const {
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += p.list ? 0 : io::size_in_bytes(p.type);
  return size;
}

PlyHeader read_ply_header(const Source& source) {
  PlyHeader header;
  HeaderLines lines(source);
  lines.next();  // "ply"
  bool has_format = false;
  for (;;) {
    const std::string_view line = lines.next();
    Row row(line);
    const std::string_view keyword = row.word();
    if (keyword == "end_header") break;
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "format") {
      header.format = read_format(row, source);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(row, source));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(row, source));
    } else {
      source.fail_at_line(line.data(), "unexpected " + quoted(keyword) + " in the PLY header");
    }
  }
  if (!has_format) source.fail("the PLY header has no line 'format ...'");
  header.body = lines.at();
  return header;
}

}  // namespace rimline::io
