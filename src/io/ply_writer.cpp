// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "base/parallel.h"
#include "io/writers.h"

namespace rimline::io {
namespace {

// Triangles without a place in the map: of components that are no disc with holes, or where none was made.
std::size_t count_unmapped(const Cloud& cloud, const Triangles& triangles) {
  const Column* u = cloud.find("u");
  if (u == nullptr || u->type != Scalar::Float64) return 0;
  return static_cast<std::size_t>(std::ranges::count_if(
      triangles, [&](const auto& t) { return std::isnan(u->value(static_cast<std::size_t>(t[0]))); }));
}

// Said in the file itself: what reads it may take NaN for a fault.
std::string comment_on_map(const Cloud& cloud, const Triangles* triangles) {
  const std::size_t unmapped = triangles == nullptr ? 0 : count_unmapped(cloud, *triangles);
  if (unmapped == 0) return "";
  return "\ncomment u and v are nan where a component has no map: " + std::to_string(unmapped) + " of " +
         std::to_string(triangles->size()) + " triangles";
}

std::string header(const Cloud& cloud, const Triangles* triangles, const std::vector<Column>& face_columns) {
  std::string text = "ply\nformat binary_little_endian 1.0" + comment_on_map(cloud, triangles) +
                     "\nelement vertex " + std::to_string(cloud.points.size());
  for (const char* axis : {"x", "y", "z"}) {
    text.append("\nproperty ").append(name(cloud.coordinate_type)).append(" ").append(axis);
  }
  for (const Column& column : cloud.columns) {
    text.append("\nproperty ").append(name(column.type)).append(" ").append(column.name);
  }
  if (triangles != nullptr) {
    text.append("\nelement face ").append(std::to_string(triangles->size()));
    text.append("\nproperty list uchar int vertex_indices");
    for (const Column& column : face_columns)
      text.append("\nproperty ").append(name(column.type)).append(" ").append(column.name);
  }
  return text + "\nend_header\n";
}

template <class T>
void place(char* to, T value) {
  std::memcpy(to, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(to, to + sizeof(T));
}

// Records of the points [begin, end), put together column by column: each loop moves one type only.
class Records {
 public:
  explicit Records(const Cloud& cloud) : cloud_(cloud), record_(3 * size_in_bytes(cloud.coordinate_type)) {
    for (const Column& column : cloud.columns) record_ += size_in_bytes(column.type);
  }

  std::size_t bytes() const { return record_; }  // of one

  void put(std::size_t begin, std::size_t end, char* to) const {
    std::size_t offset = cloud_.coordinate_type == Scalar::Float32 ? put_points<float>(begin, end, to)
                                                                   : put_points<double>(begin, end, to);
    for (const Column& column : cloud_.columns) {
      put_column(column, begin, end, to + offset);
      offset += size_in_bytes(column.type);
    }
  }

 private:
  template <class T>
  std::size_t put_points(std::size_t begin, std::size_t end, char* to) const {
    for (std::size_t i = begin; i < end; ++i, to += record_) {
      const Point& p = cloud_.points[i];
      place(to, static_cast<T>(p.x));
      place(to + sizeof(T), static_cast<T>(p.y));
      place(to + 2 * sizeof(T), static_cast<T>(p.z));
    }
    return 3 * sizeof(T);
  }

  template <std::size_t size>
  void put_values(const std::byte* from, std::size_t count, char* to) const {
    for (std::size_t i = 0; i < count; ++i, from += size, to += record_) {
      std::memcpy(to, from, size);
      if constexpr (std::endian::native == std::endian::big) std::reverse(to, to + size);
    }
  }

  void put_column(const Column& column, std::size_t begin, std::size_t end, char* to) const {
    const std::size_t size = size_in_bytes(column.type);
    const std::byte* from = column.bytes.data() + begin * size;
    switch (size) {
      case 1: return put_values<1>(from, end - begin, to);
      case 2: return put_values<2>(from, end - begin, to);
      case 4: return put_values<4>(from, end - begin, to);
      default: return put_values<8>(from, end - begin, to);
    }
  }

  const Cloud& cloud_;
  std::size_t record_;
};

// Writes records of `size` bytes each, which put(begin, end, to) makes of some of the items.
template <class Put>
void write_records(SafeFile& file, std::size_t count, std::size_t size, const Run& run, const Put& put) {
  constexpr std::size_t slice = 4096;
  const Run silent = run.without_progress();
  std::vector<char> bytes;
  for (std::size_t begin = 0; begin < count; begin += items_per_look) {
    run.progress(Stage::Write, begin, count);
    const std::size_t here = std::min(count - begin, items_per_look);
    bytes.resize(here * size);
    const auto put_slice = [&](std::size_t from, std::size_t to) {
      put(begin + from, begin + to, bytes.data() + from * size);
    };
    parallel_slices(here, Stage::Write, silent, put_slice, slice);
    file.write({bytes.data(), bytes.size()});
  }
}

void write_faces(SafeFile& file, const Triangles& triangles, const Run& run,
                 const std::vector<Column>& columns) {
  constexpr std::size_t own = 1 + 3 * sizeof(Index);
  std::size_t record = own;
  for (const Column& column : columns) record += size_in_bytes(column.type);
  write_records(file, triangles.size(), record, run, [&](std::size_t begin, std::size_t end, char* to) {
    for (std::size_t t = begin; t < end; ++t, to += record) {
      *to = 3;
      for (std::size_t c = 0; c < 3; ++c) place(to + 1 + c * sizeof(Index), triangles[t][c]);
      char* value = to + own;
      for (const Column& column : columns) {
        const std::size_t size = size_in_bytes(column.type);
        std::memcpy(value, column.bytes.data() + t * size, size);
        if constexpr (std::endian::native == std::endian::big) std::reverse(value, value + size);
        value += size;
      }
    }
  });
}

}  // namespace

void write_ply(SafeFile& file, const Cloud& cloud, const Triangles* triangles, const Run& run,
               const std::vector<Column>& face_columns) {
  file.write(header(cloud, triangles, face_columns));
  const Records records(cloud);
  write_records(file, cloud.points.size(), records.bytes(), run,
                [&](std::size_t begin, std::size_t end, char* to) { records.put(begin, end, to); });
  if (triangles != nullptr) write_faces(file, *triangles, run, face_columns);
}

Point write_ply_mesh(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  write_ply(file, mesh.cloud, &mesh.triangles, run, mesh.face_columns);
  return {};
}

}  // namespace rimline::io
