// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/ply_faces.h"

#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "rimline/run.h"

namespace rimline::bench {
namespace {

struct Property {
  std::string type, count_type, name;  // count_type is empty but for lists
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool ascii = false;
  std::vector<Element> elements;
};

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::CannotRead, path + ": " + why);
}

Property read_property(std::istream& words) {
  Property p;
  words >> p.type;
  if (p.type == "list") words >> p.count_type >> p.type;
  words >> p.name;
  return p;
}

Header read_header(std::istream& in, const std::string& path) {
  Header header;
  std::string line, word;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "end_header") return header;
    if (word == "format") {
      words >> word;
      header.ascii = word == "ascii";
      if (word == "binary_big_endian") fail(path, "big-endian faces are not read here");
    } else if (word == "element") {
      Element& e = header.elements.emplace_back();
      words >> e.name >> e.count;
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(words));
    }
  }
  fail(path, "no end_header");
}

std::size_t width(const std::string& type, const std::string& path) {
  static const std::map<std::string, std::size_t> widths = {
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = widths.find(type);
  if (found == widths.end()) fail(path, "unknown type " + type);
  return found->second;
}

// A non-negative integer: of a list's length or of an id, where the sign of the type does not matter.
std::uint64_t read_integer(std::istream& in, bool ascii, std::size_t bytes) {
  std::uint64_t value = 0;
  if (ascii) {
    in >> value;
  } else {
    in.read(reinterpret_cast<char*>(&value), static_cast<std::streamsize>(bytes));
  }
  return value;
}

void skip_value(std::istream& in, bool ascii, std::size_t bytes) {
  std::string word;
  if (ascii) {
    in >> word;
  } else {
    in.ignore(static_cast<std::streamsize>(bytes));
  }
}

void read_list(std::istream& in, bool ascii, const Property& p, const std::string& path,
               std::vector<Index>& ids) {
  const auto count = read_integer(in, ascii, width(p.count_type, path));
  if (!in || count > 1'000'000) fail(path, "a face is broken");
  ids.clear();
  for (std::uint64_t i = 0; i < count; ++i) {
    ids.push_back(static_cast<Index>(read_integer(in, ascii, width(p.type, path))));
  }
}

void read_element(std::istream& in, bool ascii, const Element& e, const std::string& path,
                  std::vector<Triangle>& faces) {
  std::vector<Index> ids;
  for (std::size_t row = 0; row < e.count; ++row) {
    for (const Property& p : e.properties) {
      if (p.count_type.empty()) {
        skip_value(in, ascii, width(p.type, path));
        continue;
      }
      read_list(in, ascii, p, path, ids);
      if (e.name != "face" || p.name.rfind("vertex_ind", 0) != 0) continue;
      for (std::size_t i = 1; i + 1 < ids.size(); ++i) faces.push_back({ids[0], ids[i], ids[i + 1]});
    }
    if (!in) fail(path, "it ends within element " + e.name);
  }
}

}  // namespace

std::vector<Triangle> read_ply_faces(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "can not be opened");
  const Header header = read_header(in, path);
  std::vector<Triangle> faces;
  for (const Element& e : header.elements) read_element(in, header.ascii, e, path, faces);
  return faces;
}

}  // namespace rimline::bench
