// SPDX-License-Identifier: GPL-3.0-or-later
// One reader per format. All throw CannotRead; none is called with an empty source. A cloud without points
// is refused by the caller. The readers of faces get the points that the reader of points found.
#pragma once

#include "io/faces.h"
#include "io/source.h"
#include "rimline/cloud.h"
#include "rimline/mesh.h"

namespace rimline::io {

Cloud read_ply(const Source& source, const Run& run);
Cloud read_text(const Source& source, const Run& run);
Cloud read_obj(const Source& source, const Run& run);
Cloud read_off(const Source& source, const Run& run);
Cloud read_pcd(const Source& source, const Run& run);
Cloud read_stl(const Source& source, const Run& run);
Cloud read_ptx(const Source& source, const Run& run);
Cloud read_npy(const Source& source, const Run& run);
Cloud read_glb(const Source& source, const Run& run);
Cloud read_scan(const Source& source, const Run& run);  // LAS, LAZ, COPC, E57; of the optional component

void read_ply_faces(const Source& source, const Cloud& cloud, Faces& faces);
void read_obj_faces(const Source& source, const Cloud& cloud, Faces& faces);
void read_off_faces(const Source& source, const Cloud& cloud, Faces& faces);
void read_stl_faces(const Source& source, const Cloud& cloud, Faces& faces);
void read_glb_faces(const Source& source, const Cloud& cloud, Faces& faces);

// LOOPS.json, schema 1, as rimline::read_loops reads it.
std::vector<Loop> read_loops(const Source& source, std::size_t point_count, const Run& run = {});

// True where the size is the one that the number of triangles in the header asks for.
bool is_stl_binary(std::string_view bytes);

// Whether the first lines are the head of a scan of a PTX: sides, pose and matrix.
bool is_ptx(std::string_view bytes);
bool is_npy(std::string_view bytes);
bool is_glb(std::string_view bytes);

// Tells the format by the content, then by the ending of the source's name, and reads it.
Cloud read_any(const Source& source, const Run& run);

}  // namespace rimline::io
