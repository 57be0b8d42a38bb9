// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ, OFF, STL, and the choice among the formats of a mesh.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "io/colours.h"
#include "io/float_places.h"
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

// A file of another ending beside the mesh.
struct FileBeside {
  std::string path, name;
};

FileBeside file_beside(const std::string& path, const std::string& ending) {
  const std::string whole = path.substr(0, path.rfind('.') + 1) + ending;
  return {whole, whole.substr(whole.rfind('/') + 1)};
}

// The material that an OBJ's texture belongs to, and the texture.
void write_material(const std::string& path, const std::string& picture) {
  const FileBeside material = file_beside(path, "mtl"), image = file_beside(path, "png");
  write_text(image.path, picture);
  write_text(material.path,
             "newmtl surface\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " + image.name + "\n");
}

// OBJ and OFF have no NaN. Points without a finite position are in no triangle; they are written at the first
// finite point.
class FinitePlaces {
 public:
  explicit FinitePlaces(const Cloud& cloud) : cloud_(cloud) {
    const auto first = std::find_if(cloud.points.begin(), cloud.points.end(), is_finite);
    if (first != cloud.points.end()) instead_ = *first;
  }
  void write(SafeFile& file, std::size_t i) const {
    write_point(file, is_finite(cloud_.points[i]) ? cloud_.points[i] : instead_, cloud_.coordinate_type);
  }

 private:
  const Cloud& cloud_;
  Point instead_;
};

// "v x y z r g b", colours from 0 to 1 as most programs write and read them.
void write_obj_places(SafeFile& file, const Cloud& cloud, const Run& run) {
  const FinitePlaces places(cloud);
  const std::optional<Colours> colours = colours_of(cloud);
  for_each_written(cloud.points.size(), run, [&](std::size_t i) {
    file.write("v ");
    places.write(file, i);
    for (std::size_t c = 0; colours && c < 3; ++c) {
      file.write(' ');
      file.number(static_cast<float>(colours->share(static_cast<Index>(i), c)));
    }
    file.write('\n');
  });
}

// Points without a value are in no triangle, or have their places in the seams.
void write_finite(SafeFile& file, double value, Scalar type) {
  std::isfinite(value) ? write_coordinate(file, value, type) : file.write('0');
}

void write_obj_uv(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const Column &u = *mesh.cloud.find("u"), &v = *mesh.cloud.find("v");
  const std::size_t points = mesh.cloud.points.size();
  for_each_written(points + mesh.dress.seams.uv.size(), run, [&](std::size_t i) {
    const auto id = static_cast<Index>(i);
    const UV at = i < points ? UV{u.value(id), v.value(id)} : mesh.dress.seams.uv[i - points];
    file.write("vt ");
    write_finite(file, at.u, u.type);
    file.write(' ');
    write_finite(file, at.v, v.type);
    file.write('\n');
  });
}

// The input's normals, or else those of the mesh, as floats: more digits are not needed.
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

// "7/9/7": place and normal of a corner share their number, its place in the texture has one of its own.
void write_obj_corner(SafeFile& file, Index id, std::optional<Index> texture) {
  const long long number = static_cast<long long>(id) + 1;
  file.write(' ');
  file.number(number);
  file.write('/');
  if (texture) file.number(static_cast<long long>(*texture) + 1);
  file.write('/');
  file.number(number);
}

}  // namespace

Point write_obj(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const auto& [cloud, triangles, ignored, dress, path] = mesh;
  const bool uv = cloud.find("u") != nullptr && cloud.find("v") != nullptr;
  if (!dress.picture.empty()) file.write("mtllib " + file_beside(path, "mtl").name + "\n");
  write_obj_places(file, cloud, run);
  if (uv) write_obj_uv(file, mesh, run);
  write_obj_normals(file, cloud, triangles, run);
  if (!dress.picture.empty()) file.write("usemtl surface\n");
  for_each_written(triangles.size(), run, [&](std::size_t t) {
    file.write('f');
    for (std::size_t c = 0; c < 3; ++c)
      write_obj_corner(file, triangles[t][c], uv ? std::optional(mesh.corners(t)[c]) : std::nullopt);
    file.write('\n');
  });
  return {};
}

Point write_off(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const auto& [cloud, triangles, ignored, dress, path] = mesh;
  file.write("OFF\n" + std::to_string(cloud.points.size()) + " " + std::to_string(triangles.size()) + " 0\n");
  const FinitePlaces places(cloud);
  for_each_written(cloud.points.size(), run, [&](std::size_t i) {
    places.write(file, i);
    file.write('\n');
  });
  for_each_written(triangles.size(), run, [&](std::size_t t) {
    file.write('3');
    for (const Index id : triangles[t]) {
      file.write(' ');
      file.number(static_cast<long long>(id));
    }
    file.write('\n');
  });
  return {};
}

// The header, which must not start with "solid", tells what has to be added.
std::string stl_header(Point offset) {
  std::string header = "binary STL";
  if (offset != Point{}) header += fmt::format(", add {} {} {}", offset.x, offset.y, offset.z);
  header.resize(80, ' ');
  return header;
}

Point write_stl(SafeFile& file, const MeshToWrite& mesh, const Run& run) {
  const auto& [cloud, triangles, ignored, dress, path] = mesh;
  const Point offset = offset_for_floats(mesh);
  check_floats(mesh, offset, file.name() + ": STL");
  file.write(stl_header(offset));
  file.little(static_cast<std::uint32_t>(triangles.size()));
  for_each_written(triangles.size(), run, [&](std::size_t t) {
    std::array<Point, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = cloud.points[triangles[t][c]] - offset;
    Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = norm(normal);
    if (length > 0) normal = (1 / length) * normal;
    for (const Point& p : {normal, corners[0], corners[1], corners[2]}) {
      for (const double value : {p.x, p.y, p.z}) file.little(static_cast<float>(value));
    }
    file.little(std::uint16_t{0});
  });
  return offset;
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

WrittenMesh write_mesh(const std::string& path, const Cloud& cloud, const std::vector<Triangle>& triangles,
                       const Run& run, const std::vector<Column>& face_columns, const Dress& dress) {
  check_mesh_path(path);
  io::SafeFile file(path);
  const io::Format& format = *io::mesh_format(io::ending_of(path));
  WrittenMesh written;
  written.offset = format.write_mesh(file, {cloud, triangles, face_columns, dress, path}, run);
  run.progress(Stage::Write, 1, 1);
  if (!dress.picture.empty() && io::ending_of(path) == "obj") io::write_material(path, dress.picture);
  file.commit();
  if (written.offset == Point{}) return written;
  const auto& [x, y, z] = written.offset;
  written.notices.push_back(fmt::format(
      "{}: {} has 32 bits a coordinate, too few for these: {}, {} and {} were taken off x, y and z; "
      "add them, or write PLY",
      path, format.about.name, x, y, z));
  return written;
}

}  // namespace rimline
