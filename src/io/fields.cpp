// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fields.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

#include "base/parallel.h"

namespace rimline::io {
namespace {

template <class T, bool Swap>
T load_value(const char* from) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), from, sizeof(T));
  if constexpr (Swap) std::reverse(bytes.begin(), bytes.end());
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

// The records [begin, end): a slice that stays in the cache while all fields are taken from it.
struct Slice {
  std::size_t begin = 0, end = 0;
};

template <class T, bool Swap>
void take_coordinate(const Field& field, Slice slice, double Point::*axis, std::vector<Point>& points) {
  const char* from = field.first + slice.begin * field.stride;
  for (std::size_t i = slice.begin; i < slice.end; ++i, from += field.stride) {
    points[i].*axis = static_cast<double>(load_value<T, Swap>(from));
  }
}

template <class T, bool Swap>
void take_values(const Field& field, Slice slice, std::byte* to) {
  const char* from = field.first + slice.begin * field.stride;
  for (std::size_t i = slice.begin; i < slice.end; ++i, from += field.stride) {
    const T value = load_value<T, Swap>(from);
    std::memcpy(to + i * sizeof(T), &value, sizeof(T));
  }
}

// Calls body(T{}) with the type that `type` stands for.
template <class Body>
void with_type(FieldType type, const Body& body) {
  switch (type) {
    case FieldType::Int8: return body(std::int8_t{});
    case FieldType::UInt8: return body(std::uint8_t{});
    case FieldType::Int16: return body(std::int16_t{});
    case FieldType::UInt16: return body(std::uint16_t{});
    case FieldType::Int32: return body(std::int32_t{});
    case FieldType::UInt32: return body(std::uint32_t{});
    case FieldType::Float32: return body(float{});
    case FieldType::Float64: return body(double{});
    case FieldType::Int64: return body(std::int64_t{});
    case FieldType::UInt64: return body(std::uint64_t{});
  }
}

// Unsigned integers of the same width stand for all types where only bytes are moved: a float in a register
// may change the bits of a signalling NaN.
template <class Body>
void with_width(std::size_t width, const Body& body) {
  switch (width) {
    case 1: return body(std::uint8_t{});
    case 2: return body(std::uint16_t{});
    case 4: return body(std::uint32_t{});
    default: return body(std::uint64_t{});
  }
}

void take_coordinate(const Field& field, Slice slice, bool swap, double Point::*axis,
                     std::vector<Point>& points) {
  with_type(field.type, [&](auto value) {
    using T = decltype(value);
    swap ? take_coordinate<T, true>(field, slice, axis, points)
         : take_coordinate<T, false>(field, slice, axis, points);
  });
}

void take_values(const Field& field, Slice slice, bool swap, std::byte* to) {
  with_width(size_in_bytes(field.type), [&](auto value) {
    using T = decltype(value);
    swap ? take_values<T, true>(field, slice, to) : take_values<T, false>(field, slice, to);
  });
}

const Field* find_field(const std::vector<Field>& fields, std::string_view name) {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

const Field& coordinate_field(const std::vector<Field>& fields, std::string_view name, const Source& source) {
  if (const Field* field = find_field(fields, name)) return *field;
  const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  if (const Field* field = find_field(fields, std::string(1, capital))) return *field;
  std::string names;
  for (const Field& field : fields) names += (names.empty() ? "" : " ") + field.name;
  source.fail("the points have no property " + quoted(name) + "; it has " + quoted(names) +
              "; rename the coordinates to x, y, z");
}

bool is_wide(FieldType type) { return type == FieldType::Int64 || type == FieldType::UInt64; }

template <class T>
std::vector<T> values_of(const std::vector<std::byte>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

// Every integer of at most 53 bits is a double; the check is stricter than needed and needs no rounding.
template <class T>
void add_wide_columns(const std::string& name, const std::vector<T>& values, std::vector<Column>& columns) {
  constexpr auto limit = T{1} << 53;
  const bool fits = std::all_of(values.begin(), values.end(), [](T v) {
    return v <= limit && (std::is_unsigned_v<T> || v >= T{0} - limit);
  });
  if (fits) {
    columns.push_back(make_column(name, std::vector<double>(values.begin(), values.end())));
    return;
  }
  std::vector<std::uint32_t> low;
  std::vector<std::conditional_t<std::is_signed_v<T>, std::int32_t, std::uint32_t>> high;
  for (const T v : values) {
    low.push_back(static_cast<std::uint32_t>(static_cast<std::uint64_t>(v)));
    high.push_back(static_cast<typename decltype(high)::value_type>(v >> 32));
  }
  columns.push_back(make_column(name + "_low", low));
  columns.push_back(make_column(name + "_high", high));
}

// Columns as they came, wide integers turned into types that PLY has.
std::vector<Column> finished_columns(const std::vector<Field>& fields,
                                     std::vector<std::vector<std::byte>> bytes) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].type == FieldType::Int64) {
      add_wide_columns(fields[i].name, values_of<std::int64_t>(bytes[i]), columns);
    } else if (fields[i].type == FieldType::UInt64) {
      add_wide_columns(fields[i].name, values_of<std::uint64_t>(bytes[i]), columns);
    } else {
      columns.push_back({fields[i].name, static_cast<Scalar>(fields[i].type), std::move(bytes[i])});
    }
  }
  return columns;
}

}  // namespace

std::size_t size_in_bytes(FieldType type) {
  return is_wide(type) ? 8 : size_in_bytes(static_cast<Scalar>(type));
}

void check_point_count(const Source& source, std::uint64_t count) {
  constexpr std::uint64_t most = 2147483646;  // 2^31 - 2: ids are 32-bit integers
  if (count > most) {
    source.fail("has " + std::to_string(count) + " points; at most " + std::to_string(most) +
                " can be handled; split or thin the cloud");
  }
}

Cloud cloud_from_fields(const std::vector<Field>& fields, std::size_t count, bool swap_bytes,
                        const Source& source, const Run& run) {
  const std::array<const Field*, 3> xyz = {&coordinate_field(fields, "x", source),
                                           &coordinate_field(fields, "y", source),
                                           &coordinate_field(fields, "z", source)};
  const bool floats =
      std::all_of(xyz.begin(), xyz.end(), [](auto* f) { return f->type == FieldType::Float32; });
  Cloud cloud;
  cloud.coordinate_type = floats ? Scalar::Float32 : Scalar::Float64;
  cloud.coordinates = xyz[0]->name + ", " + xyz[1]->name + ", " + xyz[2]->name;
  cloud.points.resize(count);
  std::vector<Field> others;
  for (const Field& field : fields) {
    if (&field != xyz[0] && &field != xyz[1] && &field != xyz[2]) others.push_back(field);
  }
  std::vector<std::vector<std::byte>> bytes(others.size());
  for (std::size_t i = 0; i < others.size(); ++i) bytes[i].resize(count * size_in_bytes(others[i].type));

  constexpr std::size_t slice_size = 4096;
  constexpr std::array<double Point::*, 3> axes = {&Point::x, &Point::y, &Point::z};
  const Run silent = run.without_progress();
  for (std::size_t begin = 0; begin < count; begin += items_per_look) {
    source.progress(run, begin, count);
    const auto take = [&](std::size_t from, std::size_t to) {
      const Slice slice{begin + from, begin + to};
      for (int axis = 0; axis < 3; ++axis)
        take_coordinate(*xyz[axis], slice, swap_bytes, axes[axis], cloud.points);
      for (std::size_t i = 0; i < others.size(); ++i)
        take_values(others[i], slice, swap_bytes, bytes[i].data());
    };
    parallel_slices(std::min(count - begin, items_per_look), Stage::Read, silent, take, slice_size);
  }
  cloud.columns = finished_columns(others, std::move(bytes));
  make_names_usable(cloud.columns);
  return cloud;
}

void values_of_field(const Field& field, std::size_t count, bool swap_bytes, double* to, std::size_t stride) {
  with_type(field.type, [&](auto value) {
    using T = decltype(value);
    const char* from = field.first;
    for (std::size_t i = 0; i < count; ++i, from += field.stride, to += stride)
      *to = static_cast<double>(swap_bytes ? load_value<T, true>(from) : load_value<T, false>(from));
  });
}

std::size_t lay_out(std::vector<Field>& fields, const char* first) {
  std::size_t size = 0;
  for (Field& field : fields) {
    field.first = first == nullptr ? nullptr : first + size;
    size += size_in_bytes(field.type);
  }
  for (Field& field : fields) field.stride = size;
  return size;
}

bool read_value(Row& row, FieldType type, char* to) {
  bool good = false;
  with_type(type, [&](auto value) {
    good = row.read(value);
    std::memcpy(to, &value, sizeof(value));
  });
  return good;
}

void make_names_usable(std::vector<Column>& columns) {
  std::set<std::string> taken = {"x", "y", "z"};
  std::map<std::string, int> copies;  // of a name so far: the next number to try
  for (Column& column : columns) {
    for (char& c : column.name) {
      if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f') c = '_';
    }
    if (column.name.empty()) column.name = "unnamed";
    const std::string wanted = column.name;
    int& copy = copies.try_emplace(wanted, 2).first->second;
    while (!taken.insert(column.name).second) column.name = wanted + "_" + std::to_string(copy++);
  }
}

}  // namespace rimline::io
