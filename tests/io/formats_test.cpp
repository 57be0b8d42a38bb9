// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ, OFF, STL, and telling formats apart.
#include <cstdint>

#include "io/files.h"

namespace rimline {
namespace {

const std::vector<Point> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};

TEST_CASE("an OBJ gives its vertices, weights and colours") {
  const std::string rest = "vt 0 0\nf 1 2 3\n";
  CHECK(
      read_bytes("a.obj", "# x\nmtllib m.mtl\no thing\nv 0 0 0\nv  1 0 0 # note\nv 0 1 .5\n" + rest).points ==
      triangle);
  const Cloud coloured = read_bytes("a.obj", "v 0 0 0 1 0.5 0\nv 1 0 0 0 0 0\nv 0 1 .5 0.25 1 1\n" + rest);
  CHECK(coloured.points == triangle);
  CHECK(values(coloured, "green") == std::vector<double>{0.5, 0, 1});
  CHECK(values(read_bytes("a.obj", "v 0 0 0 2\nv 1 1 1 1\n"), "w") == std::vector<double>{2, 1});
}

TEST_CASE("normals of an OBJ are kept only where they are those of the vertices") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 .5\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n";
  CHECK(read_bytes("a.obj", vertices).normals() == std::vector<Point>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  CHECK(read_bytes("a.obj", vertices + "f 1//1 2//2 3/9/3\nf -3//-3 -2//-2 -1//-1\n").normals().size() == 3);
  CHECK(read_bytes("a.obj", vertices + "f 1//1 2//1 3//1\n").normals().empty());
  CHECK(read_bytes("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 .5\nvn 0 0 1\nf 1//1 2//1 3//1\n").normals().empty());
}

TEST_CASE("every kind of OFF gives its vertices") {
  for (const std::string text :
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 .5\n3 0 1 2\n", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 .5\n3 0 1 2",
        "OFF # c\n# c\n\n3 0 0\n0 0 0\n1 0 0 # c\n\n0 1 .5", "3 1 0\n0 0 0\n1 0 0\n0 1 .5\n"}) {
    CAPTURE(text);
    CHECK(read_bytes("a.off", text).points == triangle);
  }
  const Cloud all = read_bytes("a.off", "STCNOFF\n1 0 0\n1 2 3 0 0 1 255 128 0 255 0.5 0.25\n");
  CHECK(all.points == std::vector<Point>{{1, 2, 3}});
  CHECK(all.normals() == std::vector<Point>{{0, 0, 1}});
  CHECK(all.find("green")->type == Scalar::UInt8);
  CHECK(values(all, "green")[0] == 128);
  CHECK(values(all, "alpha")[0] == 255);
  CHECK(values(all, "t")[0] == 0.25);
  CHECK(values(read_bytes("a.off", "COFF\n1 0 0\n1 2 3 0.5 1 0\n"), "red")[0] == 0.5);
}

std::string binary_stl(const std::vector<std::vector<Point>>& triangles, std::string header = "") {
  header.resize(80, ' ');
  header += bytes_of(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& corners : triangles) {
    header += std::string(12, '\0');
    for (const Point& p : corners) {
      header += bytes_of(static_cast<float>(p.x)) + bytes_of(static_cast<float>(p.y)) +
                bytes_of(static_cast<float>(p.z));
    }
    header += std::string(2, '\0');
  }
  return header;
}

TEST_CASE("corners of an STL that coincide become one point, in order of appearance") {
  const std::vector<std::vector<Point>> two = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}},
                                               {{1, 0, 0}, {1, 1, -0.0}, {0, 1, 0.5}}};
  const std::vector<Point> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}, {1, 1, 0}};
  const Cloud binary = read_bytes("a.stl", binary_stl(two));
  CHECK(binary.points == expected);
  CHECK(binary.coordinate_type == Scalar::Float32);
  CHECK(read_bytes("-", binary_stl(two, "solid, says a liar")).points == expected);
  const Cloud text =
      read_bytes("a.stl",
                 "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
                 "   vertex 0 1 5e-1\n  endloop\n endfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\n"
                 "vertex 1 1 -0\nvertex 0 1 .5\nendloop\nendfacet\nendsolid a\n");
  CHECK(text.points == expected);
}

TEST_CASE("a long strip in STL has each of its points once") {
  std::vector<std::vector<Point>> strip;
  for (int i = 0; i < 5000; ++i) strip.push_back({{1.0 * i, 0, 0}, {1.0 * i + 1, 0, 0}, {1.0 * i, 1, 0}});
  CHECK(read_bytes("a.stl", binary_stl(strip)).points.size() == 10001);
}

TEST_CASE("the content tells the format, whatever the ending") {
  CHECK(read_bytes("a.txt", "OFF\n1 0 0\n1 2 3\n").points.size() == 1);
  CHECK(read_bytes("a.off",
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
                   "float z\nend_header\n1 2 3\n")
            .points.size() == 1);
  CHECK(read_bytes("standard input", "v 1 2 3\nv 4 5 6\n").points.size() == 2);
  CHECK(read_bytes("standard input", "1 2 3\n").points.size() == 1);
  CHECK(read_bytes("noending", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n")
            .points.size() == 1);
}

TEST_CASE("text of any format may start with the byte order mark of UTF-8") {
  const std::string mark = "\xef\xbb\xbf", line = "1 2 3\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nend_header\n";
  const std::string pcd = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n";
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"a.ply", ply + line},
                                                        {"a.pcd", pcd + line},
                                                        {"a.off", "OFF\n1 0 0\n" + line},
                                                        {"a.obj", "v " + line},
                                                        {"a.xyz", line},
                                                        {"noending", ply + line}}) {
    CAPTURE(name);
    CHECK(read_bytes(name, mark + text).points == std::vector<Point>{{1, 2, 3}});
  }
  CHECK(contains(complaint("a.xyz", mark), "is empty"));
  CHECK(contains(complaint("a.xyz", mark + "1 2 3\n1 2 z\n"), "line 2: 'z' is not a number"));
  std::string stl = binary_stl({triangle});
  stl.replace(0, 3, mark);  // its first 80 bytes are anybody's
  CHECK(read_bytes("a.stl", stl).points.size() == 3);
}

TEST_CASE("what can not be read is named, each with its own remedy") {
  CHECK(contains(complaint("a.ply", ""), "a.ply: is empty"));
  CHECK(contains(complaint("a.ply.gz", "\x1f\x8b\x08..."), "unpack it once"));
  std::string wide;
  for (const char c : std::string("1.5 2.5 3.5\n4.5 5.5 6.5\n")) wide += {c, '\0'};
  CHECK(contains(complaint("a.xyz", wide), "is UTF-16 text; save it as UTF-8"));
  CHECK(contains(complaint("a.xyz", '\0' + wide), "is UTF-16 text; save it as UTF-8"));
  CHECK(contains(complaint("a.zip", "PK\x03\x04..."), "unzip"));
  CHECK(contains(complaint("a.las", "LASF..."), "a.las: "));
  CHECK(contains(complaint("a.ply", "1 2 3\n"), "does not start as PLY does"));
  CHECK(contains(complaint("a.pcd", "1 2 3\n"), "does not start as PCD does"));
  CHECK(contains(complaint("a.bin", std::string("\x00\x01\x02\x03", 4)), "no format that is known"));
  CHECK(contains(complaint("a.obj", "vt 0 0\n"), "no line starts with 'v'"));
  CHECK(contains(complaint("a.obj", "v 1 2 3\nv 1 2\n"), "line 2: this vertex has 2 values"));
  CHECK(contains(complaint("a.obj", "v 1 2 3\nv 1 2 z\n"), "line 2: 'z' is not a number"));
  CHECK(contains(complaint("a.off", "OFF BINARY\n"), "binary OFF"));
  CHECK(contains(complaint("a.off", "OFF\n3 0 0\n1 2 3\n"), "before the 3 vertices"));
  CHECK(contains(complaint("a.off", "OFF\n1000000000000 0 0\n1 2 3\n"), "at most 2147483646"));
  CHECK(contains(complaint("a.off", "OFF\n2 1 0\n1 2 3\n3 0 0 0\n"), "line 4: this vertex has 4 values"));
  CHECK(contains(complaint("a.off", "XOFF\n1 0 0\n1 2 3\n"), "unknown kind of OFF"));
  CHECK(contains(complaint("a.off", "OFF 1 0 0 1 2 3\n"), "line 1: expected no more than the numbers"));
  CHECK(contains(complaint("a.off", "OFF\n1 0 x\n1 2 3\n"), "found 'x' after them"));
  CHECK(contains(complaint("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2\n"),
                 "line 4: a vertex needs three numbers"));
  CHECK(contains(complaint("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\n"), "endsolid"));
  CHECK(contains(complaint("a.stl", binary_stl({triangle, triangle}).substr(0, 150)),
                 "before the 2 triangles"));
}

TEST_CASE(
    "a line of very many numbers, and a header of very many points, take no memory that the file has not") {
  std::string line = "OFF\n100000 0 0\n";
  for (int i = 0; i < 240000; ++i) line += "1 ";
  for (int i = 1; i < 100000; ++i) line += "\n1 2 3";
  CHECK(
      contains(complaint("a.off", line), "line 4: this vertex has 3 values where those before have 240000"));
}

TEST_CASE("files that are no files are named") {
  const TemporaryDirectory directory;
  const auto message = [](const std::string& path) -> std::string {
    try {
      read_cloud(path, {});
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::CannotRead);
      return error.what();
    }
    return {};
  };
  CHECK(contains(message(directory.file("missing.ply")), "missing.ply: there is no such file"));
  CHECK(contains(message(directory.file("")), "is a directory"));
  CHECK(contains(message(directory.file("empty.ply", "")), "is empty"));
}

TEST_CASE("reading can be cancelled and reports how far it is") {
  const std::string text = [] {
    std::string lines;
    for (int i = 0; i < 200000; ++i) lines += "1 2 3\n";
    return lines;
  }();
  std::atomic<bool> stop = false;
  std::vector<Progress> seen;
  Run run;
  run.stop = &stop;
  run.on_progress = [&](Progress progress) {
    seen.push_back(progress);
    if (seen.size() == 2) stop = true;
  };
  CHECK_THROWS_AS(read_bytes("a.xyz", text, run), Error);
  CHECK(seen.size() == 2);
  stop = false;
  CHECK(read_bytes("a.xyz", text, run).points.size() == 200000);
  for (std::size_t i = 3; i < seen.size(); ++i) CHECK(seen[i].done >= seen[i - 1].done);
  CHECK(seen.back().done == seen.back().total);
}

}  // namespace
}  // namespace rimline
