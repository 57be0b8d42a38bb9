// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: the lines `v`, and `vn` where there is one for each vertex.
#include <algorithm>
#include <string>

#include "io/fields.h"
#include "io/lines.h"
#include "io/readers.h"
#include "io/table.h"

namespace rimline::io {
namespace {

// Columns of a `v` line by their number: x y z [w], x y z r g b, x y z w r g b.
std::vector<std::string> vertex_names(std::size_t width) {
  switch (width) {
    case 3: return {"x", "y", "z"};
    case 4: return {"x", "y", "z", "w"};
    case 6: return {"x", "y", "z", "red", "green", "blue"};
    case 7: return {"x", "y", "z", "w", "red", "green", "blue"};
    default: return {};
  }
}

class ObjReader {
 public:
  ObjReader(const Source& source, const Run& run) : source_(source), run_(run) {}

  Cloud read() {
    Lines lines(source_.bytes());
    std::string_view line;
    for (std::size_t number = 0; lines.next_filled(line, '#'); ++number) {
      if (number % items_per_look == 0) source_.progress(run_, lines.at());
      Row row(line);
      const std::string_view keyword = row.word();
      if (keyword == "v") read_vertex(row);
      if (keyword == "vn") read_normal(row);
      if (keyword == "f") read_face(row);
    }
    if (vertices_.names.empty()) source_.fail("has no points: no line starts with 'v'");
    Cloud cloud = cloud_from_table(vertices_, source_, run_);
    if (normals_match_ && normals_.size() == 3 * cloud.points.size()) add_normals(cloud);
    return cloud;
  }

 private:
  std::size_t read_numbers(Row& row, std::vector<double>& to) const {
    std::size_t count = 0;
    for (; !row.done() && *row.at() != '#'; ++count) {
      double value = 0;
      if (!row.read(value))
        source_.fail_at_line(row.at(), quoted(Row(row).word()) +
                                           " is not a number; correct the line, or export the file again");
      to.push_back(value);
    }
    return count;
  }

  void read_vertex(Row& row) {
    const char* at = row.at();
    const std::size_t width = read_numbers(row, vertices_.values);
    if (vertices_.names.empty()) vertices_.names = vertex_names(width);
    if (vertices_.names.empty()) {
      source_.fail_at_line(at, "a vertex has x y z, then maybe w, then maybe r g b; this one has " +
                                   std::to_string(width) + " values");
    }
    if (width != vertices_.width()) {
      source_.fail_at_line(at, "this vertex has " + std::to_string(width) +
                                   " values where those before have " + std::to_string(vertices_.width()) +
                                   "; give all vertices the same");
    }
  }

  void read_normal(Row& row) {
    const char* at = row.at();
    if (read_numbers(row, normals_) != 3) source_.fail_at_line(at, "a normal has three values");
  }

  // Normals are the points' own where every corner v//n has n = v.
  void read_face(Row& row) {
    while (normals_match_ && !row.done()) {
      const std::string_view corner = row.word();
      const std::size_t slash = corner.rfind('/');
      if (slash == std::string_view::npos || slash == corner.find('/')) continue;
      long long vertex = 0, normal = 0;
      read_number(corner.data(), corner.data() + corner.size(), vertex);
      read_number(corner.data() + slash + 1, corner.data() + corner.size(), normal);
      if (vertex < 0) vertex += 1 + static_cast<long long>(vertices_.rows());  // counted back from here
      if (normal < 0) normal += 1 + static_cast<long long>(normals_.size() / 3);
      normals_match_ = normal == 0 || normal == vertex;
    }
  }

  void add_normals(Cloud& cloud) const {
    constexpr const char* names[3] = {"nx", "ny", "nz"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      values.reserve(cloud.points.size());
      for (std::size_t i = axis; i < normals_.size(); i += 3) values.push_back(normals_[i]);
      set_column(cloud, make_column(names[axis], values));
    }
  }

  const Source& source_;
  const Run& run_;
  Table vertices_;
  std::vector<double> normals_;
  bool normals_match_ = true;
};

}  // namespace

Cloud read_obj(const Source& source, const Run& run) { return ObjReader(source, run).read(); }

// Lines `f v`, `f v/vt/vn`; ids count from 1, or back from the last vertex read.
void read_obj_faces(const Source& source, const Cloud&, Faces& faces) {
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
      faces.corner(id < 0 ? vertices + id : id - 1, corner.data(), Faces::Place::Line, 1);
    }
    faces.close();
  }
}

}  // namespace rimline::io
