// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <string>

#include "io/files.h"
#include "rimline/io.h"

namespace rimline {

TEST_CASE("a mesh is read back from every format that it is written in") {
  Cloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const char* ending : {"ply", "obj", "off", "stl", "glb"}) {
    CAPTURE(ending);
    const TemporaryDirectory folder;
    const std::string path = folder.file(std::string("mesh.") + ending);
    write_mesh(path, cloud, triangles, {});
    const MeshFile mesh = read_mesh(path, {});
    CHECK(mesh.cloud.points == cloud.points);
    CHECK(mesh.triangles == triangles);
  }
}

TEST_CASE("properties of faces are written where they belong and stepped over when read") {
  Cloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const TemporaryDirectory folder;
  const std::string path = folder.file("mesh.ply");
  write_mesh(path, cloud, triangles, {},
             {make_column("filled", std::vector<std::uint8_t>{0, 1}),
              make_column("stretch_l2", std::vector<float>{1.5F, 2.5F})});
  CHECK(read_mesh(path, {}).triangles == triangles);
  const std::string bytes = content_of(path);
  CHECK(bytes.find(
            "property list uchar int vertex_indices\nproperty uchar filled\nproperty float stretch_l2\n") !=
        std::string::npos);
}

TEST_CASE("polygons become fans, and ids may count back from the last vertex") {
  const TemporaryDirectory folder_obj;
  const std::string obj = folder_obj.file(
      "mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1 2/2 3/3 4/4\nf -4//1 -3//1 -2//1\n");
  CHECK(read_mesh(obj, {}).triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  const TemporaryDirectory folder_off;
  const std::string off = folder_off.file("mesh.off", "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  CHECK(read_mesh(off, {}).triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  const TemporaryDirectory folder_ply;
  const std::string ply =
      folder_ply.file("mesh.ply",
                      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                      "property float z\nelement face 1\nproperty uchar flag\n"
                      "property list uchar int vertex_index\nend_header\n"
                      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n7 4 0 1 2 3\n");
  CHECK(read_mesh(ply, {}).triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

// Counting through them takes a day. Builds for sanitizers would show it; an optimizer may take such a loop
// away.
TEST_CASE("records without properties have no bytes, however many a PLY says there are") {
  const TemporaryDirectory folder;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement nothing 3445173350830411\nelement vertex 3\n"
      "property char x\nproperty char y\nproperty char z\nelement face 1\n"
      "property list uchar uchar vertex_indices\nend_header\n";
  for (const int byte : {0, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2}) bytes += static_cast<char>(byte);
  CHECK(read_mesh(folder.file("a.ply", bytes), {}).triangles == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("a mesh without faces, or whose faces name no vertex, is refused") {
  const TemporaryDirectory folder_none_at_all;
  const std::string none_at_all = folder_none_at_all.file("points.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  CHECK_THROWS_AS(read_mesh(none_at_all, {}), Error);
  const TemporaryDirectory folder_beyond;
  const std::string beyond = folder_beyond.file("mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n");
  CHECK_THROWS_AS(read_mesh(beyond, {}), Error);
  const TemporaryDirectory folder_cut;
  const std::string cut =
      folder_cut.file("mesh.ply",
                      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                      "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                      "0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n");
  CHECK_THROWS_AS(read_mesh(cut, {}), Error);
}

TEST_CASE("a face that names no vertex is told by its line or byte, with the remedy") {
  const TemporaryDirectory folder;
  const auto message = [&](const std::string& name, const std::string& text) -> std::string {
    try {
      read_mesh(folder.file(name, text), {});
    } catch (const Error& error) {
      return error.what();
    }
    return "was read";
  };
  const std::string remedy = "correct the face, or export the mesh again";
  const std::string obj = message("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 9\n");
  CHECK(contains(obj, "a.obj, line 5: a face names the vertex 9, but the file has 3 vertices; " + remedy));
  const std::string off = message("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  CHECK(contains(off, "a.off, line 6: a face names the vertex 3, but the file has 3 vertices; " + remedy));
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n";
  CHECK(
      contains(message("a.ply", header + "0 0 0\n3 0 0 -1\n"), "a.ply, line 11: a face names the vertex -1"));
}

}  // namespace rimline
