// SPDX-License-Identifier: GPL-3.0-or-later
// Files in and out: every format that the library has. Columns pass as arrays of their own type.
#include <fmt/format.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <tuple>

#include "arrays.h"
#include "call.h"
#include "checks.h"
#include "loops.h"
#include "parts.h"
#include "rimline/formats.h"
#include "rimline/io.h"

namespace rimline::python {
namespace {

using AnyList = nb::ndarray<nb::numpy, nb::ro, nb::shape<-1>, nb::c_contig, nb::device::cpu>;

// Calls visit(scalar, value of its type) for each type a column can have.
template <class Visit>
void visit_types(const Visit& visit) {
  visit(Scalar::Int8, std::int8_t{});
  visit(Scalar::UInt8, std::uint8_t{});
  visit(Scalar::Int16, std::int16_t{});
  visit(Scalar::UInt16, std::uint16_t{});
  visit(Scalar::Int32, std::int32_t{});
  visit(Scalar::UInt32, std::uint32_t{});
  visit(Scalar::Float32, float{});
  visit(Scalar::Float64, double{});
}

nb::object give_column(Column column) {
  const std::size_t count = column.bytes.size() / size_in_bytes(column.type);
  auto* kept = new std::vector<std::byte>(std::move(column.bytes));
  const nb::capsule owner(kept, [](void* m) noexcept { delete static_cast<std::vector<std::byte>*>(m); });
  nb::object made;
  visit_types([&]<class T>(Scalar type, T) {
    if (type == column.type) made = nb::cast(array_over<T>(reinterpret_cast<T*>(kept->data()), count, owner));
  });
  return made;
}

Column column_of(const std::string& column_name, const AnyList& values, std::size_t rows) {
  check_size(values.shape(0), rows, fmt::format("column '{}'", column_name).c_str());
  Column column;
  column.name = column_name;
  bool known = false;
  visit_types([&]<class T>(Scalar type, T) {
    if (values.dtype() != nb::dtype<T>()) return;
    known = true;
    column.type = type;
  });
  if (!known)
    throw nb::type_error(fmt::format("column '{}' has a type that no file holds", column_name).c_str());
  column.bytes.resize(rows * size_in_bytes(column.type));
  if (rows > 0) std::memcpy(column.bytes.data(), values.data(), column.bytes.size());
  return column;
}

std::vector<Column> columns_of(const Dict& columns, std::size_t rows) {
  std::vector<Column> made;
  for (const auto [key, values] : columns) {
    made.push_back(column_of(nb::cast<std::string>(key), nb::cast<AnyList>(values), rows));
  }
  return made;
}

}  // namespace

std::vector<RasterCell> raster_of(const Dict& columns, std::size_t rows) {
  Cloud cloud;
  cloud.points.resize(rows);
  cloud.columns = columns_of(columns, rows);
  return cloud.raster();
}

namespace {

// Coordinates as the file had them: floats where it had floats.
nb::object give_points(Cloud& cloud) {
  if (cloud.coordinate_type != Scalar::Float32) return nb::cast(give(std::move(cloud.points)));
  std::vector<std::array<float, 3>> floats(cloud.points.size());
  for (std::size_t i = 0; i < floats.size(); ++i) {
    const Point p = cloud.points[i];
    floats[i] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }
  return nb::cast(give(std::move(floats)));
}

// Points, columns by name, format.
Several cloud_to_python(Cloud cloud) {
  Dict columns;
  const nb::object points = give_points(cloud);
  for (Column& column : cloud.columns) {
    const std::string key = column.name;
    columns[key.c_str()] = give_column(std::move(column));
  }
  return nb::make_tuple(points, columns, cloud.format);
}

Several read_cloud_of(const std::string& path, const RunArguments& run) {
  return cloud_to_python(call(run, [&](const Run& r) { return read_cloud(path, r); }));
}

Several read_mesh_of(const std::string& path, const RunArguments& run) {
  MeshFile file = call(run, [&](const Run& r) { return read_mesh(path, r); });
  return nb::make_tuple(cloud_to_python(std::move(file.cloud)), give(std::move(file.triangles)));
}

Cloud cloud_of(const PointRows& rows, bool as_floats, const Dict& columns) {
  const Points points = as_points(rows);
  Cloud cloud;
  cloud.points.assign(points.begin(), points.end());
  cloud.coordinate_type = as_floats ? Scalar::Float32 : Scalar::Float64;
  cloud.columns = columns_of(columns, points.size());
  return cloud;
}

void write_cloud_of(const std::string& path, const PointRows& points, bool as_floats, const Dict& columns,
                    const RunArguments& run) {
  const Cloud cloud = cloud_of(points, as_floats, columns);
  call(run, [&](const Run& r) {
    write_cloud(path, cloud, r);
    return true;
  });
}

// Of a result: uv, point and corners, or nothing.
Seams seams_of(const Dict& given, std::size_t points, std::size_t triangles) {
  Seams seams;
  if (!given.contains("uv")) return seams;
  const auto uv = as_uv(nb::cast<UvRows>(given["uv"]));
  const auto owners = as_span(nb::cast<List<Index>>(given["point"]));
  seams.uv.assign(uv.begin(), uv.end());
  seams.point.assign(owners.begin(), owners.end());
  seams.corners = as_triangles(nb::cast<TriangleRows>(given["corners"]));
  check_triangles(seams.corners, points + seams.uv.size());
  const auto is_point = [&](Index id) { return id >= 0 && static_cast<std::size_t>(id) < points; };
  if (seams.point.size() != seams.uv.size() || seams.corners.size() != triangles ||
      !std::ranges::all_of(seams.point, is_point))
    throw nb::value_error("seams do not belong to this mesh");
  return seams;
}

void write_mesh_of(const std::string& path, const PointRows& points, bool as_floats, const Dict& columns,
                   const TriangleRows& ids, const Dict& face_columns, const Dict& given_seams,
                   const RunArguments& run) {
  const Cloud cloud = cloud_of(points, as_floats, columns);
  const std::vector<Triangle> triangles = as_triangles(ids);
  check_triangles(triangles, cloud.points.size());
  const std::vector<Column> of_faces = columns_of(face_columns, triangles.size());
  const Seams seams = seams_of(given_seams, points.shape(0), triangles.size());
  check_mesh_path(path);
  call(run, [&](const Run& r) {
    write_mesh(path, cloud, triangles, r, of_faces, {seams});
    return true;
  });
}

void write_loops_of(const std::string& path, const Items& given, const PointRows& points,
                    const RunArguments& run) {
  const std::vector<Loop> loops = loops_from_python(given, points.shape(0));
  check_loops_path(path);
  call(run, [&](const Run& r) {
    write_loops(path, loops, as_points(points), r);
    return true;
  });
}

// One dictionary a format: what it is called, its endings, and what this build can do with it.
Items formats() {
  Items all;
  for (const FileFormat& format : file_formats()) {
    Dict one;
    Items endings;
    for (const std::string_view ending : format.endings) endings.append(std::string(ending));
    one["name"] = std::string(format.name);
    one["endings"] = endings;
    one["reads_points"] = serves(format, FormatUse::ReadPoints);
    one["reads_faces"] = serves(format, FormatUse::ReadFaces);
    one["writes_mesh"] = serves(format, FormatUse::WriteMesh);
    one["writes_loops"] = serves(format, FormatUse::WriteLoops);
    all.append(one);
  }
  return all;
}

}  // namespace

void add_files(nb::module_& m) {
  m.def("read_cloud", &read_cloud_of, nb::arg("path"), nb::arg("run"));
  m.def("read_mesh", &read_mesh_of, nb::arg("path"), nb::arg("run"));
  m.def("write_cloud", &write_cloud_of, nb::arg("path"), nb::arg("points"), nb::arg("as_floats"),
        nb::arg("columns"), nb::arg("run"));
  m.def("write_mesh", &write_mesh_of, nb::arg("path"), nb::arg("points"), nb::arg("as_floats"),
        nb::arg("columns"), nb::arg("triangles"), nb::arg("face_columns"), nb::arg("seams"), nb::arg("run"));
  m.def("write_loops", &write_loops_of, nb::arg("path"), nb::arg("loops"), nb::arg("points"), nb::arg("run"));
  m.def("formats", &formats);
  m.def("mesh_endings", [] { return written_endings(FormatUse::WriteMesh); });
  m.def("check_mesh_path", &check_mesh_path, nb::arg("path"));
  m.def("check_loops_path", &check_loops_path, nb::arg("path"));
}

}  // namespace rimline::python
