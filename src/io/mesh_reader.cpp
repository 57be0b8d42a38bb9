// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a mesh file, beside its points. Polygons become fans.
#include <algorithm>
#include <bit>
#include <cstring>
#include <unordered_map>

#include "io/fields.h"
#include "io/lines.h"
#include "io/ply_header.h"
#include "io/readers.h"
#include "rimline/io.h"

namespace rimline {
namespace io {
namespace {

// Faces of points that are known, checked as they come.
class Faces {
 public:
  Faces(const Source& source, std::size_t points) : source_(source), points_(points) {}

  // Corner by corner; ids count from 0.
  void corner(long long id) {
    if (id < 0 || id >= static_cast<long long>(points_))
      source_.fail("a face names the vertex " + std::to_string(id) + " of " + std::to_string(points_));
    face_.push_back(static_cast<Index>(id));
  }
  void close() {
    for (std::size_t i = 2; i < face_.size(); ++i) {
      const Triangle t{face_[0], face_[i - 1], face_[i]};
      if (t[0] != t[1] && t[1] != t[2] && t[0] != t[2]) triangles.push_back(t);
    }
    face_.clear();
  }

  std::vector<Triangle> triangles;

 private:
  const Source& source_;
  std::size_t points_;
  std::vector<Index> face_;
};

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
      if (!row.read(id)) source.fail_at_line(row.at(), quoted(row.rest()) + " is no id of a vertex");
      faces.corner(id);
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
        for (long long k = 0; k < count; ++k)
          faces.corner(integer_at(values + static_cast<std::size_t>(k) * size, property.type, swap));
        faces.close();
      }
    }
  }
}

void read_ply_faces(const Source& source, Faces& faces) {
  const PlyHeader header = read_ply_header(source);
  header.format == PlyHeader::Format::Ascii ? read_ascii_faces(header, faces, source)
                                            : read_binary_faces(header, faces, source);
}

// Lines `f v`, `f v/vt/vn`; ids count from 1, or back from the last vertex read.
void read_obj_faces(const Source& source, Faces& faces) {
  Lines lines(source.bytes());
  std::string_view line;
  long long vertices = 0;
  while (lines.next_filled(line, '#')) {
    Row row(line);
    const std::string_view keyword = row.word();
    vertices += keyword == "v";
    if (keyword != "f") continue;
    while (!row.done()) {
      const std::string_view corner = row.word();
      if (corner.front() == '#') break;
      long long id = 0;
      const std::size_t slash = std::min(corner.find('/'), corner.size());
      if (read_number(corner.data(), corner.data() + slash, id) != corner.data() + slash)
        source.fail_at_line(corner.data(), quoted(corner) + " is no corner of a face");
      faces.corner(id < 0 ? vertices + id : id - 1);
    }
    faces.close();
  }
}

// After the counts and the vertices, a line for each face.
void read_off_faces(const Source& source, std::size_t points, Faces& faces) {
  Lines lines(source.bytes());
  std::string_view line;
  long long vertices = -1, count = 0;
  std::size_t passed = 0;
  while (lines.next_filled(line, '#')) {
    Row row(line);
    if (vertices < 0) {
      if (!row.read(vertices)) {
        row.word();  // the keyword, whose line may hold the counts
        if (row.done() || !row.read(vertices)) {
          vertices = -1;
          continue;
        }
      }
      row.read(count);
      continue;
    }
    if (passed++ < points) continue;
    if (count-- <= 0) return;
    long long corners = 0, id = 0;
    if (!row.read(corners)) source.fail_at_line(row.at(), "a face starts with its number of corners");
    for (; corners > 0; --corners) {
      if (!row.read(id)) source.fail_at_line(row.at(), "a face with fewer corners than it says");
      faces.corner(id);
    }
    faces.close();
  }
}

// STL repeats places; equal ones are one point, in the order in which read_cloud met them.
struct PlaceHash {
  std::size_t operator()(const Point& p) const {
    std::size_t hash = 0;
    for (const double value : {p.x, p.y, p.z}) hash = hash * 1000003 ^ std::hash<double>{}(value);
    return hash;
  }
};

void read_stl_faces(const Source& source, const std::vector<Point>& points, Faces& faces) {
  std::unordered_map<Point, Index, PlaceHash> ids;
  for (std::size_t i = 0; i < points.size(); ++i) ids.emplace(points[i], static_cast<Index>(i));
  const auto corner = [&](const Point& p) {
    const auto found = ids.find(p);
    faces.corner(found == ids.end() ? none : found->second);
  };
  constexpr std::size_t header = 84, record = 50;
  if (is_stl_binary(source.bytes())) {
    for (const char* at = source.begin() + header; source.bytes_from(at) >= record; at += record) {
      for (int c = 0; c < 3; ++c) {
        std::array<float, 3> place{};
        for (int i = 0; i < 3; ++i) {
          const auto bits = static_cast<std::uint32_t>(integer_at(at + 12 + 12 * c + 4 * i, FieldType::UInt32,
                                                                  std::endian::native == std::endian::big));
          place[i] = std::bit_cast<float>(bits);
        }
        corner({place[0], place[1], place[2]});
      }
      faces.close();
    }
    return;
  }
  Lines lines(source.bytes());
  std::string_view line;
  int corners = 0;
  while (lines.next_filled(line)) {
    Row row(line);
    if (row.word() != "vertex") continue;
    Point p;
    if (!row.read(p.x) || !row.read(p.y) || !row.read(p.z)) source.fail_at_line(row.at(), "no vertex");
    corner(p);
    if (++corners % 3 == 0) faces.close();
  }
}

std::vector<Triangle> read_faces(const Source& source, const Cloud& cloud) {
  Faces faces(source, cloud.points.size());
  if (cloud.format.starts_with("PLY")) {
    read_ply_faces(source, faces);
  } else if (cloud.format == "OBJ") {
    read_obj_faces(source, faces);
  } else if (cloud.format == "OFF") {
    read_off_faces(source, cloud.points.size(), faces);
  } else if (cloud.format.starts_with("STL")) {
    read_stl_faces(source, cloud.points, faces);
  }
  if (faces.triangles.empty()) source.fail("has no faces; a mesh is wanted here, as PLY, OBJ, OFF or STL");
  return std::move(faces.triangles);
}

}  // namespace
}  // namespace io

MeshFile read_mesh(const std::string& path, const Run& run) {
  const io::Source source = io::load(path, run);
  try {
    MeshFile mesh;
    mesh.cloud = io::read_any(source, run);
    mesh.triangles = io::read_faces(source, mesh.cloud);
    return mesh;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::OutOfMemory, source.name() + ": it does not fit into memory");
  }
}

}  // namespace rimline
