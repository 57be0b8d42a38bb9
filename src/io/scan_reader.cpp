// SPDX-License-Identifier: GPL-3.0-or-later
// LAS, LAZ, COPC and E57 through the optional component in scan_formats/.
#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "io/fields.h"
#include "io/readers.h"
#include "io/scan_formats/rimline_scan_formats.h"

namespace rimline::io {
namespace {

struct Close {
  void operator()(RimlineScan* scan) const { rimline_scan_close(scan); }
};
using Scan = std::unique_ptr<RimlineScan, Close>;
using Message = std::array<char, 512>;

Scan open(const Source& source) {
  Message message{};
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(source.begin());
  Scan scan(rimline_scan_open(bytes, source.bytes().size(), message.data(), message.size()));
  if (scan == nullptr) source.fail(message.data());
  return scan;
}

// The type of a column, for kinds as the C header numbers them.
constexpr std::array<Scalar, 7> scalars = {Scalar::UInt8,  Scalar::Int16,   Scalar::UInt16, Scalar::Int32,
                                           Scalar::UInt32, Scalar::Float32, Scalar::Float64};

template <class T>
void append(double value, std::vector<std::byte>& bytes) {
  const T number = static_cast<T>(value);
  const auto* from = reinterpret_cast<const std::byte*>(&number);
  bytes.insert(bytes.end(), from, from + sizeof(T));
}

// Checks the memory for all points in advance: a compressed file can hold many.
void check_memory(const Source& source, const Cloud& cloud, std::uint64_t count, const Run& run) {
  std::uint64_t size = sizeof(Point);
  for (const Column& column : cloud.columns) size += size_in_bytes(column.type);
  if (run.memory_limit == 0 || count * size <= run.memory_limit) return;
  throw Error(ErrorCode::OutOfMemory,
              source.name() + ": its " + std::to_string(count) + " points need " +
                  std::to_string(count * size) + " bytes, more than the memory limit of " +
                  std::to_string(run.memory_limit) + "; raise the limit or thin the cloud");
}

// The declared types bound the numbers; a number out of range is clamped.
template <class T>
void append_bounded(double value, std::vector<std::byte>& bytes) {
  constexpr double least = std::numeric_limits<T>::min(), most = std::numeric_limits<T>::max();
  append<T>(value >= least ? std::min(value, most) : least, bytes);
}

void append(double value, Column& column) {
  switch (column.type) {
    case Scalar::UInt8: return append_bounded<std::uint8_t>(value, column.bytes);
    case Scalar::Int16: return append_bounded<std::int16_t>(value, column.bytes);
    case Scalar::UInt16: return append_bounded<std::uint16_t>(value, column.bytes);
    case Scalar::Int32: return append_bounded<std::int32_t>(value, column.bytes);
    case Scalar::UInt32: return append_bounded<std::uint32_t>(value, column.bytes);
    case Scalar::Float32: return append<float>(value, column.bytes);
    default: return append<double>(value, column.bytes);
  }
}

Cloud empty_cloud(const Scan& scan) {
  Cloud cloud;
  for (std::size_t c = 0; c < rimline_scan_columns(scan.get()); ++c) {
    cloud.columns.push_back(
        {rimline_scan_column_name(scan.get(), c), scalars[rimline_scan_column_kind(scan.get(), c)], {}});
  }
  cloud.format = rimline_scan_format(scan.get());
  cloud.unit = rimline_scan_unit(scan.get());
  cloud.coordinates = "x, y, z";
  return cloud;
}

}  // namespace

Cloud read_scan(const Source& source, const Run& run) {
  const Scan scan = open(source);
  const std::uint64_t count = rimline_scan_points(scan.get());
  check_point_count(source, count);
  Cloud cloud = empty_cloud(scan);
  check_memory(source, cloud, count, run);
  // Few formats hold a point in less than a byte; a file that announces more must contain them first.
  const auto sure = static_cast<std::size_t>(std::min<std::uint64_t>(count, source.bytes().size()));
  cloud.points.reserve(sure);
  for (Column& column : cloud.columns) column.bytes.reserve(sure * size_in_bytes(column.type));
  const std::size_t width = 3 + cloud.columns.size();
  for (;;) {
    source.progress(run, cloud.points.size(), count);
    Message message{};
    const double* rows = nullptr;
    const std::int64_t got =
        rimline_scan_read(scan.get(), items_per_look, &rows, message.data(), message.size());
    if (got < 0) source.fail(message.data());
    if (got == 0) break;
    for (const double* row = rows; row != rows + width * static_cast<std::size_t>(got); row += width) {
      cloud.points.push_back({row[0], row[1], row[2]});
      for (std::size_t c = 0; c < cloud.columns.size(); ++c) append(row[3 + c], cloud.columns[c]);
    }
  }
  make_names_usable(cloud.columns);
  return cloud;
}

}  // namespace rimline::io
