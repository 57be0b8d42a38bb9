// SPDX-License-Identifier: GPL-3.0-or-later
// NPY (NumPy Enhancement Proposal 1): an array of n points by three or more columns, of any number of axes
// before the last, in C or Fortran order; or of records with fields x, y and z. Halves become floats, which
// hold them all.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "io/column_names.h"
#include "io/fields.h"
#include "io/readers.h"

namespace rimline::io {
namespace {

// How the numbers of a field lie in the file.
struct Storage {
  std::size_t size = 0;  // bytes
  bool swap = false;     // not in the order of this machine
};

struct NpyHeader {
  std::vector<Field> fields;     // one without a name, or the named ones of a record
  std::vector<Storage> storage;  // of each
  bool fortran = false;
  std::vector<std::uint64_t> shape;
  const char* body = nullptr;
};

// The Python literal of the header: strings, numbers, True and False, tuples, lists and one dictionary.
class Literal {
 public:
  Literal(const Source& source, std::string_view text) : source_(source), text_(text) {}

  [[noreturn]] void fail(const std::string& message) const {
    source_.fail_at_byte(text_.data(), message + "; save it again with numpy.save");
  }
  bool take(char c) {
    skip();
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(std::string("the NPY header has no '") + c + "' where one should be");
  }
  char next() {
    skip();
    return text_.empty() ? '\0' : text_.front();
  }
  std::string string() {
    skip();
    const char quote = next();
    if (quote != '\'' && quote != '"') fail("the NPY header has no text where one should be");
    const std::size_t end = text_.find(quote, 1);
    if (end == std::string_view::npos) fail("the NPY header ends within a text");
    const std::string result(text_.substr(1, end - 1));
    text_.remove_prefix(end + 1);
    return result;
  }
  std::uint64_t number() {
    skip();
    std::uint64_t value = 0;
    const char* after = read_number(text_.data(), text_.data() + text_.size(), value);
    if (after == nullptr) fail("the NPY header has no number where one should be");
    text_.remove_prefix(static_cast<std::size_t>(after - text_.data()));
    return value;
  }
  bool boolean() {
    skip();
    const bool value = text_.starts_with("True");
    if (!value && !text_.starts_with("False")) fail("fortran_order is neither True nor False");
    text_.remove_prefix(value ? 4 : 5);
    return value;
  }

 private:
  void skip() {
    while (!text_.empty() && std::isspace(static_cast<unsigned char>(text_.front())) != 0)
      text_.remove_prefix(1);
  }

  const Source& source_;
  std::string_view text_;
};

std::optional<FieldType> type_of(std::string_view code) {
  if (code == "f2" || code == "f4") return FieldType::Float32;
  if (code == "f8") return FieldType::Float64;
  if (code == "i1") return FieldType::Int8;
  if (code == "i2") return FieldType::Int16;
  if (code == "i4") return FieldType::Int32;
  if (code == "i8") return FieldType::Int64;
  if (code == "u1" || code == "b1") return FieldType::UInt8;
  if (code == "u2") return FieldType::UInt16;
  if (code == "u4") return FieldType::UInt32;
  if (code == "u8") return FieldType::UInt64;
  return std::nullopt;
}

// "<f8" of a field.
void read_type(Literal& in, const std::string& name, NpyHeader& header) {
  const std::string text = in.string();
  const std::string_view code = std::string_view(text).substr(text.empty() ? 0 : 1);
  const auto type = type_of(code);
  if (!type) {
    in.fail(
        "the type " + quoted(text) +
        " is not known; known are integers of 1 to 8 bytes and floats of 2, 4 or 8: take a.astype(float)");
  }
  const std::size_t size = code == "f2" ? 2 : size_in_bytes(*type);
  const bool big = text.front() == '>';
  header.storage.push_back({size, size > 1 && big != (std::endian::native == std::endian::big)});
  header.fields.push_back({name, *type, nullptr, 0});
}

void read_descr(Literal& in, NpyHeader& header) {
  constexpr std::size_t most = 100000;  // largest number of fields: beyond it the header is invalid
  if (!in.take('[')) {
    read_type(in, "", header);
    return;
  }
  while (!in.take(']')) {
    in.expect('(');
    const std::string name = in.string();
    in.expect(',');
    read_type(in, name, header);
    if (in.take(',') && in.next() != ')')
      in.fail("a field that is an array is not read; take fields x, y and z");
    in.expect(')');
    in.take(',');
    if (header.fields.size() > most) in.fail("it announces too many fields");
  }
}

void read_shape(Literal& in, NpyHeader& header) {
  in.expect('(');
  while (!in.take(')')) {
    header.shape.push_back(in.number());
    in.take(',');
  }
}

NpyHeader read_header(const Source& source) {
  const std::string_view bytes = source.bytes();
  constexpr std::size_t start = 8;  // magic and version
  const std::size_t width = bytes.size() > 6 && bytes[6] == 1 ? 2 : 4;
  if (bytes.size() < start + width) source.fail("ends within its NPY header; the file is truncated");
  std::size_t length = 0;
  for (std::size_t i = 0; i < width; ++i)
    length |= std::size_t{static_cast<unsigned char>(bytes[start + i])} << (8 * i);
  if (bytes.size() - start - width < length) source.fail("ends within its NPY header; the file is truncated");
  NpyHeader header;
  header.body = bytes.data() + start + width + length;
  Literal in(source, bytes.substr(start + width, length));
  in.expect('{');
  while (!in.take('}')) {
    const std::string key = in.string();
    in.expect(':');
    if (key == "descr") {
      read_descr(in, header);
    } else if (key == "fortran_order") {
      header.fortran = in.boolean();
    } else if (key == "shape") {
      read_shape(in, header);
    } else {
      in.fail("the NPY header has an unknown entry " + quoted(key));
    }
    in.take(',');
  }
  if (header.fields.empty()) source.fail("the NPY header tells no type; save it again with numpy.save");
  return header;
}

// How many numbers or records the shape asks for (one where it has no sides); checked against the file before
// anything is taken.
std::uint64_t checked_count(const NpyHeader& header, std::size_t record, const Source& source) {
  const std::uint64_t most = source.bytes_from(header.body) / record;
  std::uint64_t count = 1;
  for (const std::uint64_t side : header.shape) {
    if (side == 0) source.fail("has no points: a side of the array is 0");
    count = count > most / side ? most + 1 : count * side;
  }
  if (count > most) {
    source.fail("ends at byte " + std::to_string(source.bytes().size()) +
                ", before all of the array that its header announces; the file is truncated");
  }
  return count;
}

std::size_t record_size(const NpyHeader& header) {
  std::size_t size = 0;
  for (const Storage& storage : header.storage) size += storage.size;
  return size;
}

// IEEE 754 binary16: a sign, five bits of exponent, ten of fraction.
float from_half(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  float size = std::ldexp(static_cast<float>(fraction), -24);
  if (exponent > 0) size = std::ldexp(static_cast<float>(1024 + fraction), exponent - 25);
  if (exponent == 31) {
    size = fraction == 0 ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
  }
  return std::copysign(size, bits >> 15 == 0 ? 1.0F : -1.0F);
}

// Whether all numbers lie in one order of bytes and as types that fields have.
bool is_uniform(const NpyHeader& header) {
  bool swap = false, keep = false;
  for (std::size_t f = 0; f < header.fields.size(); ++f) {
    const Storage& storage = header.storage[f];
    if (storage.size != size_in_bytes(header.fields[f].type)) return false;
    swap = swap || storage.swap;
    keep = keep || (storage.size > 1 && !storage.swap);
  }
  return !(swap && keep);
}

// The bytes of `count` records in the order and types of this machine; the header then tells of these.
std::vector<char> make_uniform(NpyHeader& header, std::uint64_t count) {
  std::size_t size = 0;
  for (const Field& field : header.fields) size += size_in_bytes(field.type);
  std::vector<char> made(count * size);
  const char* from = header.body;
  for (char* to = made.data(); to != made.data() + made.size();) {
    for (std::size_t f = 0; f < header.fields.size(); ++f) {
      const Storage& storage = header.storage[f];
      std::array<char, sizeof(double)> number{};
      std::copy_n(from, storage.size, number.begin());
      if (storage.swap)
        std::reverse(number.begin(), number.begin() + static_cast<std::ptrdiff_t>(storage.size));
      from += storage.size;
      const std::size_t width = size_in_bytes(header.fields[f].type);
      if (width != storage.size) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, number.data(), sizeof bits);
        const float value = from_half(bits);
        std::memcpy(number.data(), &value, sizeof value);
      }
      to = std::copy_n(number.begin(), width, to);
    }
  }
  for (std::size_t f = 0; f < header.fields.size(); ++f)
    header.storage[f] = {size_in_bytes(header.fields[f].type), false};
  header.body = made.data();
  return made;
}

bool swaps(const NpyHeader& header) {
  return std::ranges::any_of(header.storage, [](const Storage& storage) { return storage.swap; });
}

Cloud read_records(NpyHeader& header, const Source& source, const Run& run) {
  const std::uint64_t count = checked_count(header, record_size(header), source);
  check_point_count(source, count);
  std::vector<char> uniform;
  if (!is_uniform(header)) uniform = make_uniform(header, count);
  lay_out(header.fields, header.body);
  return cloud_from_fields(header.fields, count, swaps(header), source, run);
}

// The last axis are the columns; those before it, in C order, the points.
Cloud read_columns(NpyHeader& header, const Source& source, const Run& run) {
  const std::uint64_t all = checked_count(header, record_size(header), source);
  const std::uint64_t width = header.shape.empty() ? 0 : header.shape.back();
  if (header.shape.size() == 2 && header.shape[0] == 3 && width > 9) {
    source.fail("has 3 rows of " + std::to_string(width) +
                " numbers, but a point is a row; save the transposed array: numpy.save(FILE, a.T)");
  }
  if (header.shape.size() < 2 || width < 3 || width > 1000) {
    source.fail("is an array without rows of x, y and z; save one of n rows and three columns or more");
  }
  if (header.fortran && header.shape.size() != 2) {
    source.fail("has more than two axes in Fortran order; save it with numpy.ascontiguousarray");
  }
  const std::uint64_t count = all / width;
  check_point_count(source, count);
  std::vector<char> uniform;
  if (!is_uniform(header)) uniform = make_uniform(header, all);
  const FieldType type = header.fields.front().type;
  const std::size_t size = size_in_bytes(type);
  std::vector<Field> fields(width);
  for (std::size_t c = 0; c < width; ++c) {
    fields[c] = {std::string(1, static_cast<char>('x' + c % 3)), type,
                 header.body + c * (header.fortran ? count : 1) * size, (header.fortran ? 1 : width) * size};
  }
  std::string warning;
  if (width > 3) {  // the names depend on the values
    Table table;
    table.names.resize(width);
    table.values.resize(all);
    for (std::size_t c = 0; c < width; ++c)
      values_of_field(fields[c], count, swaps(header), table.values.data() + c, width);
    warning = guess_names(table);
    for (std::size_t c = 0; c < width; ++c) fields[c].name = table.names[c];
  }
  Cloud cloud = cloud_from_fields(fields, count, swaps(header), source, run);
  const std::size_t first = fields.front().name == "x" ? 1 : 2;
  cloud.coordinates = "columns " + std::to_string(first) + ", " + std::to_string(first + 1) + " and " +
                      std::to_string(first + 2);
  if (!warning.empty()) cloud.warnings.push_back(source.name() + ": " + warning);
  return cloud;
}

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with("\x93NUMPY"); }

Cloud read_npy(const Source& source, const Run& run) {
  NpyHeader header = read_header(source);
  const bool records = !header.fields.front().name.empty();
  return records ? read_records(header, source, run) : read_columns(header, source, run);
}

}  // namespace rimline::io
