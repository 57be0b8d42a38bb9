// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes files. A path may be "-" for standard input or output where the format allows it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rimline/cloud.h"
#include "rimline/mesh.h"
#include "rimline/run.h"
#include "rimline/seams.h"

namespace rimline {

// Reads the points of a file in any format of the table in rimline/formats.h that is read. The format is
// told by the content, then by the ending. Faces and lists are skipped; every other vertex property is kept
// in Cloud::columns. Rows with NaN or infinite coordinates are kept: the stages leave them out and count
// them. Throws CannotRead, naming the file, the line or byte, and what to do.
Cloud read_cloud(const std::string& path, const Run& run);

// Returns of one pulse: all; the first; the last; those of pulses with one alone.
enum class Returns { All, First, Last, Only };
const char* name(Returns returns);

struct PointFilter {
  std::vector<int> classes = {};   // of the property classification, 0 to 255; empty for all
  Returns returns = Returns::All;  // by return_number and number_of_returns
};

// Keeps the points that pass. Where some do not, Cloud::warnings tells how many, and the column file_index
// (uint) the place of each in the file, from 0. `file` is named in messages. Throws CannotRead where the
// cloud lacks a property that is asked for, or no point passes.
void filter_points(Cloud& cloud, const PointFilter& filter, const std::string& file);

// read_cloud, then filter_points.
Cloud read_cloud(const std::string& path, const PointFilter& filter, const Run& run);

// Points with triangles over them.
struct MeshFile {
  Cloud cloud;
  std::vector<Triangle> triangles;
};

// Reads the points as read_cloud does, and the faces of the formats that have them; polygons become fans,
// faces that name a vertex twice are left out. Throws CannotRead, also where there are no faces.
MeshFile read_mesh(const std::string& path, const Run& run);

// Writes the points and columns as binary little-endian PLY: coordinates in coordinate_type, input order.
// Written beside the target and renamed, so that an interrupted or failed write leaves no partial file.
// Throws CannotWrite.
void write_cloud(const std::string& path, const Cloud& cloud, const Run& run);

// The appearance of a mesh, beside the columns of its points.
struct Dress {
  Seams seams;
  std::string picture = {};  // a texture, as the bytes of a PNG; empty for none. Its first row is at v = 1.
                             // In OBJ (with a .mtl and a .png beside it) and glTF binary alone.
};

// How a mesh had to be changed for its format.
struct WrittenMesh {
  Point offset;                           // was subtracted from all coordinates: zero, but for STL
  std::vector<std::string> notices = {};  // sentences for people, which name the offset
};

// Writes points and triangles (ids within the cloud) in the format of the ending, one of
// written_endings(FormatUse::WriteMesh); "-" is PLY. The ending is checked by check_mesh_path before any
// work. Throws CannotWrite. `face_columns`, one value per triangle, are kept in PLY alone. The columns `u`
// and `v` of the cloud are its map; where it has seams, the corners' places are written too.
WrittenMesh write_mesh(const std::string& path, const Cloud& cloud, const std::vector<Triangle>& triangles,
                       const Run& run, const std::vector<Column>& face_columns = {}, const Dress& dress = {});

// Throws BadOption where write_mesh does not know the ending; the message lists those it knows.
void check_mesh_path(const std::string& path);

// Writes `text` with the same guarantee (reports, JSON).
void write_text(const std::string& path, const std::string& text);

// Whether a path is written to directly: "-", devices and pipes. Without an ending they get the format that
// "-" has, PLY or JSON.
bool is_stream(const std::string& path);

// The file that a chain of links ends in, whether it exists or not: what a write to `path` makes or replaces.
// Throws CannotWrite where the chain has no end.
std::string follow_links(const std::string& path);

// Removes what is being written at this moment under a temporary name, in any thread. Async-signal-safe: for
// a signal handler that ends the process and must leave no partial file.
void remove_unfinished_files() noexcept;

// LOOPS.json, schema 1, for a cloud of that many points. docs/formats.md
std::string loops_to_json(const std::vector<Loop>& loops, std::size_t point_count);

// Writes loops in the format of the ending, one of written_endings(FormatUse::WriteLoops); "-" is JSON. The
// ending is checked by check_loops_path. Throws CannotWrite.
void write_loops(const std::string& path, const std::vector<Loop>& loops, Points points, const Run& run);

// Throws BadOption where write_loops does not know the ending; the message lists those it knows.
void check_loops_path(const std::string& path);

// Reads the loops of a LOOPS.json, ids checked against `point_count`: in range, at least three, none twice in
// a loop (a repeated closing id is dropped), and made for as many points where it says so. Of a loop only
// `points` is required; without `kind` it is outer, until the pipeline knows
// better. Throws CannotRead, and OutOfMemory where the
// run's limit may not suffice.
std::vector<Loop> read_loops(const std::string& path, std::size_t point_count, const Run& run = {});

}  // namespace rimline
