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
std::size_t count_unmapped(const MeshToWrite& mesh) {
  const Column* u = mesh.cloud.find("u");
  if (u == nullptr || u->type != Scalar::Float64) return 0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto at = static_cast<std::size_t>(mesh.corners(t)[0]), points = mesh.cloud.points.size();
    count += std::isnan(at < points ? u->value(static_cast<Index>(at)) : mesh.dress.seams.uv[at - points].u);
  }
  return count;
}

// A comment in the file: its reader could take NaN for an error.
std::string comment_on_map(const MeshToWrite& mesh) {
  std::string text;
  if (const std::size_t unmapped = count_unmapped(mesh); unmapped > 0) {
    text += "\ncomment u and v are nan where a component has no map: " + std::to_string(unmapped) + " of " +
            std::to_string(mesh.triangles.size()) + " triangles";
  }
  if (!mesh.dress.seams.empty())
    text += "\ncomment u and v are nan on seams, where texcoord of the faces has a place for each corner";
  return text;
}

std::string header(const Cloud& cloud, const MeshToWrite* mesh) {
  std::string text = "ply\nformat binary_little_endian 1.0" + (mesh ? comment_on_map(*mesh) : "") +
                     "\nelement vertex " + std::to_string(cloud.points.size());
  for (const char* axis : {"x", "y", "z"}) {
    text.append("\nproperty ").append(name(cloud.coordinate_type)).append(" ").append(axis);
  }
  for (const Column& column : cloud.columns) {
    text.append("\nproperty ").append(name(column.type)).append(" ").append(column.name);
  }
  if (mesh != nullptr) {
    text.append("\nelement face ").append(std::to_string(mesh->triangles.size()));
    text.append("\nproperty list uchar int vertex_indices");
    if (!mesh->dress.seams.empty()) text.append("\nproperty list uchar double texcoord");
    for (const Column& column : mesh->face_columns)
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

// u and v of the three corners, after their number.
constexpr std::size_t texcoord_bytes = 1 + 6 * sizeof(double);

void put_texcoord(const MeshToWrite& mesh, const Column& u, const Column& v, std::size_t t, char* to) {
  const std::size_t points = mesh.cloud.points.size();
  *to++ = 6;
  for (const Index corner : mesh.corners(t)) {
    const bool own = static_cast<std::size_t>(corner) < points;
    const UV at = own ? UV{u.value(corner), v.value(corner)} : mesh.dress.seams.uv[corner - points];
    place(to, at.u);
    place(to + sizeof(double), at.v);
    to += 2 * sizeof(double);
  }
}

void write_faces(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const Column *u = mesh.cloud.find("u"), *v = mesh.cloud.find("v");
  const bool seams = !mesh.dress.seams.empty();
  constexpr std::size_t own = 1 + 3 * sizeof(Index);
  std::size_t record = own + (seams ? texcoord_bytes : 0);
  for (const Column& column : mesh.face_columns) record += size_in_bytes(column.type);
  write_records(file, mesh.triangles.size(), record, run, [&](std::size_t begin, std::size_t end, char* to) {
    for (std::size_t t = begin; t < end; ++t, to += record) {
      *to = 3;
      for (std::size_t c = 0; c < 3; ++c) place(to + 1 + c * sizeof(Index), mesh.triangles[t][c]);
      char* value = to + own;
      if (seams) {
        put_texcoord(mesh, *u, *v, t, value);
        value += texcoord_bytes;
      }
      for (const Column& column : mesh.face_columns) {
        const std::size_t size = size_in_bytes(column.type);
        std::memcpy(value, column.bytes.data() + t * size, size);
        if constexpr (std::endian::native == std::endian::big) std::reverse(value, value + size);
        value += size;
      }
    }
  });
}

}  // namespace

void write_ply(SafeFile& file, const Cloud& cloud, const MeshToWrite* mesh, const Run& run) {
  file.write(header(cloud, mesh));
  const Records records(cloud);
  write_records(file, cloud.points.size(), records.bytes(), run,
                [&](std::size_t begin, std::size_t end, char* to) { records.put(begin, end, to); });
  if (mesh != nullptr) write_faces(file, *mesh, run);
}

Point write_ply_mesh(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  write_ply(file, mesh.cloud, &mesh, run);
  return {};
}

}  // namespace rimline::io
