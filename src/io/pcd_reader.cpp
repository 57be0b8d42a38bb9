// SPDX-License-Identifier: GPL-3.0-or-later
// PCD 0.5 to 0.7 of the Point Cloud Library: ascii, binary, binary_compressed (always little-endian).
#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

#include "io/column_names.h"
#include "io/fields.h"
#include "io/lzf.h"
#include "io/readers.h"

namespace rimline::io {
namespace {

struct PcdField {
  std::string name;
  std::uint64_t size = 4;
  char type = 'F';
  std::uint64_t count = 1;
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::optional<std::uint64_t> width, height, points;
  std::string data;
  const char* body = nullptr;
};

std::optional<FieldType> type_of(char kind, std::uint64_t size) {
  if (kind == 'F' && size == 4) return FieldType::Float32;
  if (kind == 'F' && size == 8) return FieldType::Float64;
  if (kind == 'I' && size == 1) return FieldType::Int8;
  if (kind == 'I' && size == 2) return FieldType::Int16;
  if (kind == 'I' && size == 4) return FieldType::Int32;
  if (kind == 'I' && size == 8) return FieldType::Int64;
  if (kind == 'U' && size == 1) return FieldType::UInt8;
  if (kind == 'U' && size == 2) return FieldType::UInt16;
  if (kind == 'U' && size == 4) return FieldType::UInt32;
  if (kind == 'U' && size == 8) return FieldType::UInt64;
  return std::nullopt;
}

std::uint64_t read_count(Row& row, const Source& source) {
  std::uint64_t value = 0;
  if (!row.read(value)) source.fail_at_line(row.at(), "expected a number, found " + quoted(row.rest()));
  return value;
}

// One value for each field, from a line such as "SIZE 4 4 4".
template <class Set>
void read_each(Row& row, PcdHeader& header, const Source& source, const Set& set) {
  const char* at = row.at();
  for (PcdField& field : header.fields) {
    if (row.done()) source.fail_at_line(at, "fewer values than there are names in FIELDS");
    set(field);
  }
  if (!row.done()) source.fail_at_line(at, "more values than there are names in FIELDS");
}

void read_fields(Row& row, PcdHeader& header) {
  header.fields.clear();
  while (!row.done()) {
    header.fields.emplace_back();
    header.fields.back().name = row.word();
  }
}

// Handles one line; true after DATA, the last of the header.
bool read_header_line(Row& row, PcdHeader& header, const Source& source) {
  const std::string_view keyword = row.word();
  if (keyword == "FIELDS" || keyword == "COLUMNS") read_fields(row, header);
  if (keyword == "SIZE")
    read_each(row, header, source, [&](PcdField& f) { f.size = read_count(row, source); });
  if (keyword == "COUNT")
    read_each(row, header, source, [&](PcdField& f) { f.count = read_count(row, source); });
  if (keyword == "TYPE") read_each(row, header, source, [&](PcdField& f) { f.type = row.word().front(); });
  if (keyword == "WIDTH") header.width = read_count(row, source);
  if (keyword == "HEIGHT") header.height = read_count(row, source);
  if (keyword == "POINTS") header.points = read_count(row, source);
  if (keyword == "DATA") header.data = row.word();
  return keyword == "DATA";
}

PcdHeader read_header(const Source& source) {
  PcdHeader header;
  Lines lines(source.bytes());
  std::string_view line;
  bool complete = false;
  while (!complete && lines.next_filled(line, '#')) {
    Row row(line);
    complete = read_header_line(row, header, source);
  }
  if (!complete) source.fail("the PCD header has no line DATA; the file is truncated or not a PCD");
  if (header.fields.empty()) source.fail("the PCD header has no line FIELDS that names x y z");
  header.body = lines.at();
  return header;
}

// POINTS, or else WIDTH times HEIGHT; both must agree where both are given.
std::uint64_t point_count(const PcdHeader& header, const Source& source) {
  if (!header.width && !header.points) source.fail("the PCD header has neither POINTS nor WIDTH and HEIGHT");
  const std::uint64_t height = header.height.value_or(1);
  if (header.width) {
    check_point_count(source, *header.width);
    check_point_count(source, height);
  }
  const std::uint64_t area = header.width ? *header.width * height : *header.points;
  const std::uint64_t count = header.points.value_or(area);
  if (count != area) {
    source.fail("POINTS is " + std::to_string(count) + ", but WIDTH times HEIGHT is " + std::to_string(area) +
                "; correct the header");
  }
  check_point_count(source, count);
  return count;
}

// The Point Cloud Library's names of a normal, and PDAL's of colours (X Y Z, Red Green Blue), in those of
// PLY.
std::string ply_name(const std::string& name) {
  if (name == "normal_x") return "nx";
  if (name == "normal_y") return "ny";
  if (name == "normal_z") return "nz";
  return column_name(name);
}

// One Field for each number of a record: a PCD field may hold several. Padding, named "_", is included.
std::vector<Field> fields_of(const PcdHeader& header, const Source& source) {
  constexpr std::uint64_t most =
      100000;  // largest number of values per point: beyond it the header is invalid
  std::vector<Field> fields;
  for (const PcdField& field : header.fields) {
    const auto type = type_of(field.type, field.size);
    if (!type) {
      source.fail("field " + quoted(field.name) + " has TYPE " + quoted({&field.type, 1}) + " and SIZE " +
                  std::to_string(field.size) + "; known are F of 4 or 8 bytes, I and U of 1, 2, 4 or 8");
    }
    if (field.count > most || fields.size() > most) {
      source.fail("the PCD header announces too many numbers per point; check COUNT");
    }
    for (std::uint64_t i = 0; i < field.count; ++i) {
      const std::string name = ply_name(field.name);
      fields.push_back(
          {field.count == 1 || name == "_" ? name : name + "_" + std::to_string(i), *type, nullptr, 0});
    }
  }
  return fields;
}

[[noreturn]] void fail_truncated(const Source& source, std::uint64_t count) {
  source.fail("ends at byte " + std::to_string(source.bytes().size()) + ", before the " +
              std::to_string(count) +
              " points that the header announces; the file is truncated or its count wrong");
}

Cloud without_padding(std::vector<Field> fields, std::uint64_t count, bool swap, const Source& source,
                      const Run& run) {
  std::erase_if(fields, [](const Field& field) { return field.name == "_"; });
  return cloud_from_fields(fields, count, swap, source, run);
}

constexpr bool swap_bytes = std::endian::native == std::endian::big;

Cloud read_ascii(const PcdHeader& header, std::vector<Field> fields, std::uint64_t count,
                 const Source& source, const Run& run) {
  if ((source.bytes_from(header.body) + 1) / 2 / std::max<std::size_t>(fields.size(), 1) < count) {
    fail_truncated(source, count);
  }
  const std::size_t record = lay_out(fields, nullptr);
  std::vector<char> packed(count * record);
  Lines lines({header.body, source.bytes_from(header.body)});
  std::string_view line;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % items_per_look == 0) source.progress(run, lines.at());
    if (!lines.next_filled(line)) fail_truncated(source, count);
    Row row(line);
    char* to = packed.data() + i * record;
    for (const Field& field : fields) {
      if (!read_value(row, field.type, to)) {
        source.fail_at_line(row.at(), row.done() ? "the value of field " + quoted(field.name) + " is missing"
                                                 : quoted(Row(row).word()) + " is no value for field " +
                                                       quoted(field.name) + " of the type in the header");
      }
      to += size_in_bytes(field.type);
    }
    if (!row.done())
      source.fail_at_line(row.at(), "more values than the header names: " + quoted(row.rest()));
  }
  lay_out(fields, packed.data());
  return without_padding(std::move(fields), count, false, source, run);
}

Cloud read_binary(const PcdHeader& header, std::vector<Field> fields, std::uint64_t count,
                  const Source& source, const Run& run) {
  const std::size_t record = lay_out(fields, header.body);
  if (record == 0 || source.bytes_from(header.body) / record < count) fail_truncated(source, count);
  return without_padding(std::move(fields), count, swap_bytes, source, run);
}

std::uint32_t little_endian_32(const char* at) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(at[i])} << (8 * i);
  return value;
}

// Fields lie one after the other, each with its numbers of all points: field by field, point by point.
void lay_out_by_field(const PcdHeader& header, std::uint64_t count, const char* first,
                      std::vector<Field>& fields) {
  std::size_t next = 0;
  for (const PcdField& field : header.fields) {
    for (std::uint64_t i = 0; i < field.count; ++i, ++next) {
      fields[next].first = first + i * field.size;
      fields[next].stride = field.size * field.count;
    }
    first += field.size * field.count * count;
  }
}

Cloud read_compressed(const PcdHeader& header, std::vector<Field> fields, std::uint64_t count,
                      const Source& source, const Run& run) {
  if (source.bytes_from(header.body) < 8) fail_truncated(source, count);
  const std::size_t packed = little_endian_32(header.body), size = little_endian_32(header.body + 4);
  const char* body = header.body + 8;
  if (source.bytes_from(body) < packed) fail_truncated(source, count);
  const std::size_t record = lay_out(fields, nullptr);
  if (record == 0 || size / record != count || size % record != 0 || size / lzf_most_expansion > packed) {
    source.fail_at_byte(header.body, "the sizes of the compressed block do not fit the " +
                                         std::to_string(count) +
                                         " points of the header; export the file again");
  }
  const auto unpacked = std::make_unique_for_overwrite<char[]>(size);
  if (!lzf_decompress({body, packed}, unpacked.get(), size)) {
    source.fail_at_byte(body, "the compressed block is damaged; export the file again");
  }
  lay_out_by_field(header, count, unpacked.get(), fields);
  return without_padding(std::move(fields), count, swap_bytes, source, run);
}

}  // namespace

Cloud read_pcd(const Source& source, const Run& run) {
  const PcdHeader header = read_header(source);
  const std::uint64_t count = point_count(header, source);
  std::vector<Field> fields = fields_of(header, source);
  const auto read = [&]() -> Cloud {
    if (header.data == "ascii") return read_ascii(header, std::move(fields), count, source, run);
    if (header.data == "binary") return read_binary(header, std::move(fields), count, source, run);
    if (header.data == "binary_compressed")
      return read_compressed(header, std::move(fields), count, source, run);
    source.fail("unknown PCD data " + quoted(header.data) +
                "; known are ascii, binary and binary_compressed");
  };
  Cloud cloud = read();
  cloud.format = "PCD, " + std::string(header.data);
  return cloud;
}

}  // namespace rimline::io
