// SPDX-License-Identifier: GPL-3.0-or-later
// Collects faces over known points, checked as they are read. Polygons become fans.
#pragma once

#include <vector>

#include "io/source.h"
#include "rimline/mesh.h"

namespace rimline::io {

class Faces {
 public:
  enum class Place { Line, Byte };  // how a message names a position in the file

  Faces(const Source& source, std::size_t points) : source_(source), points_(points) {}

  // Corner by corner; `id` counts from 0, in the file from `first`. `at` is where it stands.
  void corner(long long id, const char* at, Place place, long long first = 0) {
    if (id < 0 || id >= static_cast<long long>(points_)) fail(id + first, at, place);
    face_.push_back(static_cast<Index>(id));
  }
  // Ends the polygon; triangles that name a point twice are left out.
  void close() {
    for (std::size_t i = 2; i < face_.size(); ++i) {
      const Triangle t{face_[0], face_[i - 1], face_[i]};
      if (t[0] != t[1] && t[1] != t[2] && t[0] != t[2]) triangles.push_back(t);
    }
    face_.clear();
  }

  std::vector<Triangle> triangles;

 private:
  [[noreturn]] void fail(long long id, const char* at, Place place) const {
    const std::string message = "a face names the vertex " + std::to_string(id) + ", but the file has " +
                                std::to_string(points_) +
                                " vertices; correct the face, or export the mesh again";
    place == Place::Line ? source_.fail_at_line(at, message) : source_.fail_at_byte(at, message);
  }

  const Source& source_;
  std::size_t points_;
  std::vector<Index> face_;
};

}  // namespace rimline::io
