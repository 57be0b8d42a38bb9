// SPDX-License-Identifier: GPL-3.0-or-later
// The binary little-endian PLY files that the tool writes, read without the library under test.
#pragma once

#include <array>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace rimline::test {

struct Ply {
  std::vector<std::string> properties;                  // "float x", in order
  std::map<std::string, std::vector<std::string>> raw;  // property's name -> bytes of each vertex's value
  std::vector<std::array<int, 3>> faces;
  std::vector<std::array<double, 6>> texcoord;  // of each face, or empty
  std::size_t vertices = 0;

  bool has(const std::string& property) const {
    for (const auto& own : properties) {
      if (own == property) return true;
    }
    return false;
  }

  template <class T>
  std::vector<T> values(const std::string& name) const {
    std::vector<T> result;
    for (const std::string& bytes : raw.at(name)) {
      if (bytes.size() != sizeof(T)) throw std::runtime_error("type of " + name);
      T value;
      std::memcpy(&value, bytes.data(), sizeof value);
      result.push_back(value);
    }
    return result;
  }
};

inline std::size_t ply_size(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {{"char", 1},   {"uchar", 1}, {"short", 2},
                                                           {"ushort", 2}, {"int", 4},   {"uint", 4},
                                                           {"float", 4},  {"double", 8}};
  return sizes.at(type);
}

inline Ply parse_ply(const std::string& bytes) {
  Ply ply;
  std::vector<std::pair<std::string, std::string>> columns;
  std::size_t faces = 0, at = 0;
  std::string element, line, face_lines;
  while (line != "end_header") {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) throw std::runtime_error("no end_header");
    line = bytes.substr(at, end - at);
    at = end + 1;
    std::istringstream words(line);
    std::string first, second, third, fourth, fifth;
    words >> first >> second >> third >> fourth >> fifth;
    if (first == "format" && second != "binary_little_endian") throw std::runtime_error("format " + second);
    if (first == "element") {
      element = second;
      (second == "vertex" ? ply.vertices : faces) = std::stoul(third);
    }
    if (first == "property" && element == "vertex") {
      columns.emplace_back(second, third);
      ply.properties.push_back(second + " " + third);
    }
    if (first == "property" && element == "face") face_lines += line + "\n";
  }
  const std::string ids = "property list uchar int vertex_indices\n", chart = "property int chart\n";
  const std::string places = "property list uchar double texcoord\n";
  const bool has_places = face_lines.find(places) != std::string::npos;
  const bool has_chart = face_lines.find(chart) != std::string::npos;
  if (faces > 0 && face_lines != ids + (has_places ? places : "") + (has_chart ? chart : ""))
    throw std::runtime_error(face_lines);
  for (std::size_t i = 0; i < ply.vertices; ++i) {
    for (const auto& [type, name] : columns) {
      ply.raw[name].push_back(bytes.substr(at, ply_size(type)));
      at += ply_size(type);
    }
  }
  for (std::size_t i = 0; i < faces; ++i) {
    if (at >= bytes.size() || bytes[at] != 3) throw std::runtime_error("a face that is no triangle");
    std::array<int, 3> face{};
    std::memcpy(face.data(), bytes.data() + at + 1, sizeof face);
    ply.faces.push_back(face);
    at += 1 + sizeof face;
    if (has_places) {
      if (bytes[at] != 6) throw std::runtime_error("a texcoord that is no six numbers");
      std::memcpy(ply.texcoord.emplace_back().data(), bytes.data() + at + 1, 6 * sizeof(double));
      at += 1 + 6 * sizeof(double);
    }
    if (has_chart) at += sizeof(int);
  }
  if (at != bytes.size()) throw std::runtime_error("bytes left over");
  return ply;
}

}  // namespace rimline::test
