// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files of every format: each is read or refused, and nothing else happens (run under sanitizers).
#include <liblzf/lzf.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "io/files.h"
#include "io/formats.h"

namespace rimline {
namespace {

struct Sample {
  std::string name, content;
};

std::string floats(int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += bytes_of(static_cast<float>(i) / 7);
  return bytes;
}

std::string compressed_pcd() {
  const std::string bytes = floats(60);
  std::string packed(2 * bytes.size(), '\0');
  packed.resize(lzf_compress(bytes.data(), static_cast<unsigned>(bytes.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z i _\nSIZE 4 4 4 4 4\nTYPE F F F F F\nCOUNT 1 1 1 1 2\nWIDTH "
         "10\n"
         "HEIGHT 1\nPOINTS 10\nDATA binary_compressed\n" +
         bytes_of(static_cast<std::uint32_t>(packed.size())) +
         bytes_of(static_cast<std::uint32_t>(bytes.size())) + packed;
}

std::string glb() {
  std::string json =
      R"({"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[1,2,3],"children":[1]},{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1,"NORMAL":0},"mode":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":0,"byteOffset":8,"componentType":5121,"count":4,"type":"VEC4","normalized":true}],
"bufferViews":[{"buffer":0,"byteLength":48}],"buffers":[{"byteLength":48}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t n) { return bytes_of(static_cast<std::uint32_t>(n)); };
  return "glTF" + number(2) + number(28 + json.size() + 48) + number(json.size()) + "JSON" + json +
         number(48) + std::string("BIN\0", 4) + floats(12);
}

std::vector<Sample> samples() {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string lists = "element a 2\nproperty list uchar short l\nelement vertex 3\n" + xyz +
                            "property list ushort float w\nproperty int64 t\n";
  std::string list_body = std::string("\x01\x00\x01\x00", 4);
  for (int i = 0; i < 3; ++i)
    list_body += floats(3) + std::string("\x01\x00", 2) + floats(1) + bytes_of(std::int64_t{1} << 60);
  std::string stl(80, ' ');
  stl += bytes_of(std::uint32_t{4});
  for (int i = 0; i < 4; ++i) stl += floats(12) + "..";
  return {
      {"a.ply", "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\n" + xyz +
                    "property uchar red\nproperty list int int l\nend_header\n"
                    "1 2 3 4 0\n5 6 7 8 1 9\n1.5 nan -1e9 255 2 3 4\n"},
      {"a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 10\n" + xyz +
                    "property double d\nend_header\n" + floats(50)},
      {"a.ply",
       "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 10\r\nproperty float x\r\nproperty float "
       "y\r\nproperty float z\r\nend_header\r\n" +
           floats(30)},
      {"a.ply", "ply\nformat binary_little_endian 1.0\n" + lists + "end_header\n" + list_body},
      {"a.xyz", "# head\n3\n1 2 3 0.5\n4,5,6,7\n7;8;9;1e5\n"},
      {"a.csv", "x,y,z,Scan angle,\"R\",G,B\n1,2,3,4,5,6,7\n1,nan,3,4,255,255,255\n"},
      {"a.obj", "mtllib a\nv 1 2 3 0.5 0.5 1\nv 4 5 6 1 1 1\nvn 0 0 1\nvn 1 0 0\nf 1//1 -1//-1 2/1/2\n"},
      {"a.ptx",
       "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 0 0 1\n1 2 3 0.5 1 2 3\n0 0 0 "
       "0.5 0 0 0\n"},
      {"a.npy", std::string("\x93NUMPY\x01\x00\x46\x00", 10) +
                    "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }          \n" + floats(12)},
      {"a.npy",
       std::string("\x93NUMPY\x01\x00\x71\x00", 10) +
           "{'descr': [('x', '<f4'), ('y', '<f4'), ('z', '<f4'), ('c', '|u1')], 'fortran_order': False, "
           "'shape': (2,), }    \n" +
           floats(6) + "ab"},
      {"a.glb", glb()},
      {"a.off", "STCNOFF\n2 1 0\n1 2 3 0 0 1 255 0 0 0.5 0.5\n4 5 6 0 0 1 1 2 3 0.5 0.5\n3 0 1 1\n"},
      {"a.pcd",
       "# .PCD v0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS "
       "2\nDATA ascii\n1 2 3 4\nnan 5 6 7\n"},
      {"a.pcd",
       "# .PCD v0.7\nFIELDS x y z t\nSIZE 4 4 4 8\nTYPE F F F U\nWIDTH 5\nHEIGHT 2\nPOINTS 10\nDATA "
       "binary\n" +
           floats(50)},
      {"a.pcd", compressed_pcd()},
      {"a.stl", stl},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 1 2 4\nvertex 1 5 "
       "3\nendloop\nendfacet\nendsolid\n"},
  };
}

std::string damaged(std::string content, std::mt19937_64& random) {
  static const std::vector<std::string> splinters = {
      "-1", "999999999999", "4294967295",         "18446744073709551615", "nan", "list",
      "\n", "\r",           std::string(1, '\0'), "\xff\xff\xff\xff",     ",",   "1e999"};
  for (std::size_t hits = 1 + random() % 3; hits > 0 && !content.empty(); --hits) {
    const std::size_t at = random() % content.size();
    switch (random() % 6) {
      case 0: content[at] = static_cast<char>(random()); break;
      case 1: content.resize(at); break;
      case 2: content.erase(at, 1 + random() % 16); break;
      case 3: content.insert(at, splinters[random() % splinters.size()]); break;
      case 4: content.replace(at, 1 + random() % 3, splinters[random() % splinters.size()]); break;
      default: content.insert(at, content.substr(random() % content.size(), random() % 40)); break;
    }
  }
  return content;
}

TEST_CASE("every format that is read has a sample to damage") {
  const auto all = samples();
  for (const io::Format& format : io::formats()) {
    const bool elsewhere =
        format.about.name == "LAS/LAZ/COPC" || format.about.name == "E57";  // scan_formats_test.cpp
    if (format.read == nullptr || elsewhere) continue;
    const bool here = std::any_of(all.begin(), all.end(), [&](const Sample& sample) {
      return &io::format_of(io::Source(sample.name, sample.content)) == &format;
    });
    CHECK_MESSAGE(here, format.about.name);
  }
}

TEST_CASE("whole files of every format are read") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.content.substr(0, 60));
    CHECK_NOTHROW(read_bytes(sample.name, sample.content));
  }
}

TEST_CASE("damaged files of every format are read or refused as CannotRead") {
  std::mt19937_64 random(20040501);
  for (const Sample& sample : samples()) {
    int refused = 0;
    for (int round = 0; round < 400; ++round) {
      const std::string content = damaged(sample.content, random);
      CAPTURE(content);
      try {
        const Cloud cloud = read_bytes(sample.name, content);
        bool whole = !cloud.points.empty();
        for (const Column& column : cloud.columns) {
          whole = whole && column.bytes.size() == cloud.points.size() * size_in_bytes(column.type);
        }
        CHECK(whole);
      } catch (const Error& error) {
        ++refused;
        CHECK(error.code() == ErrorCode::CannotRead);
        CHECK(contains(error.what(), sample.name));
      }
    }
    CHECK(refused > 20);
  }
}

}  // namespace
}  // namespace rimline
