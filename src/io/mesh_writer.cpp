// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ, OFF, STL, and the choice among the formats of a mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "io/formats.h"
#include "io/telling.h"
#include "rimline/io.h"

namespace rimline {
namespace io {

std::string ending_of(const std::string& path) {
  const std::string ending = lower_ending(path);
  const bool none_given = path.find('.', path.rfind('/') + 1) == std::string::npos;
  return none_given && is_stream(path) ? "ply" : ending;
}

std::vector<Point> normals_of_mesh(Points points, const Triangles& triangles) {
  std::vector<Point> normals(points.size());
  for (const Triangle& t : triangles) {
    const Point a = points[t[0]];
    const Point normal = cross(points[t[1]] - a, points[t[2]] - a);
    for (const Index corner : t) normals[corner] = normals[corner] + normal;
  }
  for (Point& normal : normals) {
    const double length = norm(normal);
    normal = length > 0 ? (1 / length) * normal : Point{};
  }
  return normals;
}

namespace {

// OBJ and OFF have no NaN. Points without a finite place are in no triangle; they are put where the first
// point is that has one, which no reader minds.
void write_places(SafeFile& file, const Cloud& cloud, const char* prefix, const Run& run) {
  const auto first = std::find_if(cloud.points.begin(), cloud.points.end(), is_finite);
  const Point place = first == cloud.points.end() ? Point{} : *first;
  for_each_written(cloud.points.size(), run, [&](std::size_t i) {
    file.write(prefix);
    write_point(file, is_finite(cloud.points[i]) ? cloud.points[i] : place, cloud.coordinate_type);
    file.write('\n');
  });
}

// Points without a value are in no triangle.
void write_finite(SafeFile& file, double value, Scalar type) {
  std::isfinite(value) ? write_coordinate(file, value, type) : file.write('0');
}

void write_obj_uv(SafeFile& file, const Column& u, const Column& v, std::size_t count, const Run& run) {
  for_each_written(count, run, [&](std::size_t i) {
    file.write("vt ");
    write_finite(file, u.value(static_cast<Index>(i)), u.type);
    file.write(' ');
    write_finite(file, v.value(static_cast<Index>(i)), v.type);
    file.write('\n');
  });
}

// The input's normals as they came, or else those of the mesh, as floats: nobody needs more of them.
void write_obj_normals(SafeFile& file, const Cloud& cloud, const Triangles& triangles, const Run& run) {
  std::vector<Point> normals = cloud.normals();
  const bool given = !normals.empty();
  if (!given) normals = normals_of_mesh(cloud.points, triangles);
  const Scalar type = given ? cloud.find("nx")->type : Scalar::Float32;
  for_each_written(normals.size(), run, [&](std::size_t i) {
    file.write("vn");
    for (const double value : {normals[i].x, normals[i].y, normals[i].z}) {
      file.write(' ');
      write_finite(file, value, type);
    }
    file.write('\n');
  });
}

// "7/7/7": place, texture and normal of a corner share their number.
void write_obj_corner(SafeFile& file, Index id, bool uv) {
  const long long number = static_cast<long long>(id) + 1;
  file.write(' ');
  file.number(number);
  file.write('/');
  if (uv) file.number(number);
  file.write('/');
  file.number(number);
}

}  // namespace

void write_obj(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const auto& [cloud, triangles, ignored] = mesh;
  const Column* u = cloud.find("u");
  const Column* v = cloud.find("v");
  const bool uv = u != nullptr && v != nullptr;
  write_places(file, cloud, "v ", run);
  if (uv) write_obj_uv(file, *u, *v, cloud.points.size(), run);
  write_obj_normals(file, cloud, triangles, run);
  for_each_written(triangles.size(), run, [&](std::size_t t) {
    file.write('f');
    for (const Index id : triangles[t]) write_obj_corner(file, id, uv);
    file.write('\n');
  });
}

void write_off(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const auto& [cloud, triangles, ignored] = mesh;
  file.write("OFF\n" + std::to_string(cloud.points.size()) + " " + std::to_string(triangles.size()) + " 0\n");
  write_places(file, cloud, "", run);
  for_each_written(triangles.size(), run, [&](std::size_t t) {
    file.write('3');
    for (const Index id : triangles[t]) {
      file.write(' ');
      file.number(static_cast<long long>(id));
    }
    file.write('\n');
  });
}

void write_stl(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const auto& [cloud, triangles, ignored] = mesh;
  std::string header = "binary STL";  // must not start with "solid"
  header.resize(80, ' ');
  file.write(header);
  file.little(static_cast<std::uint32_t>(triangles.size()));
  for_each_written(triangles.size(), run, [&](std::size_t t) {
    const std::array<Point, 3> corners = {cloud.points[triangles[t][0]], cloud.points[triangles[t][1]],
                                          cloud.points[triangles[t][2]]};
    Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = norm(normal);
    if (length > 0) normal = (1 / length) * normal;
    for (const Point& p : {normal, corners[0], corners[1], corners[2]}) {
      for (const double value : {p.x, p.y, p.z}) file.little(static_cast<float>(value));
    }
    file.little(std::uint16_t{0});
  });
}

}  // namespace io

void check_mesh_path(const std::string& path) {
  if (io::mesh_format(io::ending_of(path)) != nullptr) return;
  throw Error(ErrorCode::BadOption,
              path + ": the ending must be " + text_of_endings(FormatUse::WriteMesh) + " for a mesh");
}

void write_cloud(const std::string& path, const Cloud& cloud, const Run& run) {
  io::SafeFile file(path);
  io::write_ply(file, cloud, nullptr, run);
  run.progress(Stage::Write, 1, 1);
  file.commit();
}

void write_mesh(const std::string& path, const Cloud& cloud, const std::vector<Triangle>& triangles,
                const Run& run, const std::vector<Column>& face_columns) {
  check_mesh_path(path);
  io::SafeFile file(path);
  io::mesh_format(io::ending_of(path))->write_mesh(file, {cloud, triangles, face_columns}, run);
  run.progress(Stage::Write, 1, 1);
  file.commit();
}

}  // namespace rimline
