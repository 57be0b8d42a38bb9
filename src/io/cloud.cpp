// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/cloud.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace rimline {
namespace {

template <class T>
double load_as_double(const Column& column, Index point) {
  T value;
  std::memcpy(&value, column.bytes.data() + static_cast<std::size_t>(point) * sizeof(T), sizeof(T));
  return static_cast<double>(value);
}

template <class T>
constexpr Scalar scalar_of() {
  if constexpr (std::is_same_v<T, std::int8_t>) return Scalar::Int8;
  if constexpr (std::is_same_v<T, std::uint8_t>) return Scalar::UInt8;
  if constexpr (std::is_same_v<T, std::int16_t>) return Scalar::Int16;
  if constexpr (std::is_same_v<T, std::uint16_t>) return Scalar::UInt16;
  if constexpr (std::is_same_v<T, std::int32_t>) return Scalar::Int32;
  if constexpr (std::is_same_v<T, std::uint32_t>) return Scalar::UInt32;
  if constexpr (std::is_same_v<T, float>) return Scalar::Float32;
  return Scalar::Float64;
}

}  // namespace

std::size_t size_in_bytes(Scalar type) {
  switch (type) {
    case Scalar::Int8:
    case Scalar::UInt8: return 1;
    case Scalar::Int16:
    case Scalar::UInt16: return 2;
    case Scalar::Int32:
    case Scalar::UInt32:
    case Scalar::Float32: return 4;
    case Scalar::Float64: return 8;
  }
  return 8;
}

const char* name(Scalar type) {
  switch (type) {
    case Scalar::Int8: return "char";
    case Scalar::UInt8: return "uchar";
    case Scalar::Int16: return "short";
    case Scalar::UInt16: return "ushort";
    case Scalar::Int32: return "int";
    case Scalar::UInt32: return "uint";
    case Scalar::Float32: return "float";
    case Scalar::Float64: return "double";
  }
  return "?";
}

double Column::value(Index point) const {
  switch (type) {
    case Scalar::Int8: return load_as_double<std::int8_t>(*this, point);
    case Scalar::UInt8: return load_as_double<std::uint8_t>(*this, point);
    case Scalar::Int16: return load_as_double<std::int16_t>(*this, point);
    case Scalar::UInt16: return load_as_double<std::uint16_t>(*this, point);
    case Scalar::Int32: return load_as_double<std::int32_t>(*this, point);
    case Scalar::UInt32: return load_as_double<std::uint32_t>(*this, point);
    case Scalar::Float32: return load_as_double<float>(*this, point);
    case Scalar::Float64: return load_as_double<double>(*this, point);
  }
  return 0;
}

template <class T>
Column make_column(std::string name, const std::vector<T>& values) {
  Column column{std::move(name), scalar_of<T>(), std::vector<std::byte>(values.size() * sizeof(T))};
  if (!values.empty()) std::memcpy(column.bytes.data(), values.data(), column.bytes.size());
  return column;
}

template Column make_column(std::string, const std::vector<std::int8_t>&);
template Column make_column(std::string, const std::vector<std::uint8_t>&);
template Column make_column(std::string, const std::vector<std::int16_t>&);
template Column make_column(std::string, const std::vector<std::uint16_t>&);
template Column make_column(std::string, const std::vector<std::int32_t>&);
template Column make_column(std::string, const std::vector<std::uint32_t>&);
template Column make_column(std::string, const std::vector<float>&);
template Column make_column(std::string, const std::vector<double>&);

const Column* Cloud::find(std::string_view wanted) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.name == wanted; });
  return found == columns.end() ? nullptr : &*found;
}

std::vector<Point> Cloud::normals() const {
  const Column* nx = find("nx");
  const Column* ny = find("ny");
  const Column* nz = find("nz");
  if (nx == nullptr || ny == nullptr || nz == nullptr) return {};
  std::vector<Point> result(points.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto id = static_cast<Index>(i);
    result[i] = {nx->value(id), ny->value(id), nz->value(id)};
  }
  return result;
}

std::vector<RasterCell> Cloud::raster() const {
  constexpr double most = 2147483646;
  const Column* column = find("column");
  const Column* row = find("row");
  const Column* scan = find("scan");
  if (column == nullptr || row == nullptr || points.empty()) return {};
  const auto is_id = [&](double value) { return value >= 0 && value <= most && value == std::floor(value); };
  std::vector<RasterCell> cells(points.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto id = static_cast<Index>(i);
    const double c = column->value(id), r = row->value(id);
    if (!is_id(c) || !is_id(r) || (scan != nullptr && scan->value(id) != scan->value(0))) return {};
    cells[i] = {static_cast<Index>(c), static_cast<Index>(r)};
  }
  return cells;
}

void set_column(Cloud& cloud, Column column) {
  for (Column& present : cloud.columns) {
    if (present.name == column.name) {
      present = std::move(column);
      return;
    }
  }
  cloud.columns.push_back(std::move(column));
}

}  // namespace rimline
