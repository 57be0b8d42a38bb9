// SPDX-License-Identifier: GPL-3.0-or-later
// One writer per format, into an open file. Triangles have ids within the cloud.
#pragma once

#include <algorithm>
#include <vector>

#include "io/safe_file.h"
#include "io/source.h"
#include "rimline/cloud.h"
#include "rimline/io.h"
#include "rimline/mesh.h"
#include "rimline/run.h"

namespace rimline::io {

using Triangles = std::vector<Triangle>;

struct MeshToWrite {
  const Cloud& cloud;
  const Triangles& triangles;
  const std::vector<Column>& face_columns;
  const Dress& dress;
  const std::string& path;  // where files beside it go

  // The place of a corner among those of the points and of the seams.
  const Triangle& corners(std::size_t t) const {
    return dress.seams.empty() ? triangles[t] : dress.seams.corners[t];
  }
};

struct LoopsToWrite {
  const std::vector<Loop>& loops;
  Points points;
};

// Without triangles the PLY has no element `face`.
void write_ply(SafeFile& file, const Cloud& cloud, const MeshToWrite* mesh, const Run& run);

// All return the offset subtracted from the coordinates, which a reader of the file must add: zero, but for
// STL.
Point write_ply_mesh(SafeFile& file, const MeshToWrite& mesh, const Run& run);
Point write_obj(SafeFile& file, const MeshToWrite& mesh, const Run& run);
Point write_off(SafeFile& file, const MeshToWrite& mesh, const Run& run);
Point write_stl(SafeFile& file, const MeshToWrite& mesh, const Run& run);
Point write_glb(SafeFile& file, const MeshToWrite& mesh, const Run& run);

void write_loops_json(SafeFile& file, const LoopsToWrite& loops);
void write_loops_geojson(SafeFile& file, const LoopsToWrite& loops);
void write_loops_wkt(SafeFile& file, const LoopsToWrite& loops);
void write_loops_csv(SafeFile& file, const LoopsToWrite& loops);
void write_loops_edges(SafeFile& file, const LoopsToWrite& loops);
void write_loops_obj(SafeFile& file, const LoopsToWrite& loops);
void write_loops_dxf(SafeFile& file, const LoopsToWrite& loops);

// The part of a path after its last dot, in lower case; "ply" for "-".
std::string ending_of(const std::string& path);

// Calls body(i) for i in [0, count), with a look at Run now and then.
template <class Body>
void for_each_written(std::size_t count, const Run& run, const Body& body) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i % items_per_look == 0) run.progress(Stage::Write, i, count);
    body(i);
  }
}

// A coordinate as text with the digits that its type needs.
inline void write_coordinate(SafeFile& file, double value, Scalar type) {
  type == Scalar::Float32 ? file.number(static_cast<float>(value)) : file.number(value);
}

// "1.5 2 3"
inline void write_point(SafeFile& file, Point p, Scalar type, char separator = ' ') {
  write_coordinate(file, p.x, type);
  file.write(separator);
  write_coordinate(file, p.y, type);
  file.write(separator);
  write_coordinate(file, p.z, type);
}

// The sum of the cross products of the edges at each point, made to length 1; zero where there is none.
std::vector<Point> normals_of_mesh(Points points, const Triangles& triangles);

}  // namespace rimline::io
