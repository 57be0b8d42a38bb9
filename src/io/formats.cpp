// SPDX-License-Identifier: GPL-3.0-or-later
// The table of formats, and what is looked up in it.
#include "io/formats.h"

#include <algorithm>
#include <array>

#include "io/telling.h"

namespace rimline {
namespace io {
namespace {

bool is_not_text(std::string_view bytes) { return !is_text(bytes); }

// Texts are those of docs/formats.md; a test compares them.
std::vector<Format> make_formats() {
  return {
      {.about = {.name = "PLY",
                 .endings = {"ply"},
                 .reading = {{.told_by = "`ply`",
                              .points = "`x`, `y`, `z` of any scalar type, of the element `vertex` (else the "
                                        "first element that has them)",
                              .kept = "every other scalar property of the vertex, name, type and value, in "
                                      "order",
                              .faces = true}},
                 .mesh = {{"ply", "all points, in order, `float` or `double` as in the input",
                           "all properties, see above"}},
                 .loops = {{"ply",
                            "text; vertices with `point` (id) and `loop`, element `edge` with `vertex1 "
                            "vertex2`"}}},
       .told = tells_ply,
       .start = "ply",
       .read = read_ply,
       .read_faces = read_ply_faces,
       .write_mesh = write_ply_mesh,
       .write_loops = write_loops_edges},
      {.about = {.name = "STL",
                 .endings = {"stl"},
                 .reading = {{.told_by = "`solid`, or a size that fits its count",
                              .points = "the corners; equal ones become one point, in order of appearance",
                              .kept = "nothing",
                              .faces = true}},
                 .mesh = {{"stl", "corners of triangles, as floats",
                           "normals of the triangles. STL has no shared vertices and no doubles: large "
                           "coordinates lose digits"}}},
       .told = tells_stl,
       .may_be = is_not_text,
       .start = "solid",
       .read = read_stl,
       .read_faces = read_stl_faces,
       .write_mesh = write_stl},
      {.about = {.name = "PCD",
                 .endings = {"pcd"},
                 .reading = {{.told_by = "`# .PCD`, `VERSION`, `FIELDS`",
                              .points = "fields `x`, `y`, `z`",
                              .kept = "every other field; `normal_x` ... become `nx` ...; a field of COUNT n "
                                      "becomes `NAME_0` to `NAME_(n-1)`; padding `_` is dropped; a packed "
                                      "`rgb` stays as it is"}}},
       .told = tells_pcd,
       .start = "# .PCD",
       .read = read_pcd},
      {.about = {.name = "OFF",
                 .endings = {"off"},
                 .reading = {{.told_by = "`OFF`, `COFF`, `NOFF`, `STOFF`, `4OFF` and mixtures (text), or the "
                                         "ending",
                              .points = "the vertices",
                              .kept = "`w`, `nx ny nz`, `red green blue [alpha]`, `s t`",
                              .faces = true}},
                 .mesh = {{"off", "all points, in order, as in `.obj`", "nothing"}}},
       .told = tells_off,
       .may_be = is_text,
       .start = "OFF",
       .read = read_off,
       .read_faces = read_off_faces,
       .write_mesh = write_off},
      {.about = {.name = "OBJ",
                 .endings = {"obj"},
                 .reading = {{.told_by = "a first line `v`, `o`, `mtllib`, ..., or the ending",
                              .points = "lines `v`",
                              .kept = "weight `w`; colours `red green blue`; `vn` as `nx ny nz` where each "
                                      "vertex has its own",
                              .faces = true}},
                 .mesh = {{"obj", "all points, in order; shortest text that reads back the same",
                           "`vt` where there are `u` and `v`; `vn`, the input's or else those of the mesh; "
                           "the three share their numbers. NaN is written as 0 in `vt` and `vn`; points "
                           "without a finite place are put where the first point is that has one"}},
                 .loops = {{"obj",
                            "an object `outer_0`, `hole_1`, ... with its `v` and one closed `l` a "
                            "loop"}}},
       .told = tells_obj,
       .may_be = is_text,
       .start = "v",
       .read = read_obj,
       .read_faces = read_obj_faces,
       .write_mesh = write_obj,
       .write_loops = write_loops_obj},
      {.about = {.name = "glTF binary",
                 .endings = {"glb"},
                 .mesh = {{"glb",
                           "all points, in order, as floats about the middle of their box; the middle, in "
                           "double, is the node's translation",
                           "`NORMAL` (the input's or those of the mesh), `TEXCOORD_0` (`u`, `1 - v`, as glTF "
                           "counts v downwards), `COLOR_0` from uchar `red green blue`. Points without a "
                           "finite place are put in the middle and are in no triangle. The material is seen "
                           "from both sides. Axes are not turned"}}},
       .write_mesh = write_glb},
      {.about = {.name = "XYZ/TXT/CSV",
                 .endings = {"xyz", "txt", "csv", "pts", "asc"},
                 .reading = {{.told_by = "nothing else fits, and it is text",
                              .points = "columns `x`, `y`, `z`, or the first three",
                              .kept = "every other column"}},
                 .loops = {{"csv", "`loop,kind,order,point,x,y,z`"}}},
       .may_be = is_text,
       .read = read_text,
       .write_loops = write_loops_csv},
      {.about = {.name = "LOOPS.json", .endings = {"json"}, .loops = {{"json", "LOOPS.json; also `-`"}}},
       .write_loops = write_loops_json},
      {.about = {.name = "GeoJSON",
                 .endings = {"geojson"},
                 .loops = {{"geojson",
                            "one Feature with a closed LineString a loop; `kind`, `length`, `fitness`. "
                            "Coordinates are those of the input, in its reference system"}}},
       .write_loops = write_loops_geojson},
      {.about = {.name = "WKT",
                 .endings = {"wkt"},
                 .loops = {{"wkt", "one `LINESTRING Z (...)` a line, closed"}}},
       .write_loops = write_loops_wkt},
      {.about = {.name = "DXF",
                 .endings = {"dxf"},
                 .loops = {{"dxf", "R12, closed 3D polylines on the layers OUTER and HOLE"}}},
       .write_loops = write_loops_dxf},
  };
}

// Files that are known, and known not to be readable.
struct Refused {
  std::string_view start;
  const char* message;
};

constexpr Refused refused[] = {
    {"\x1f\x8b", "is compressed with gzip; decompress it first: gunzip -k FILE"},
    {"PK\x03\x04", "is a zip archive; unpack it first: unzip FILE"},
    {"BZh", "is compressed with bzip2; decompress it first: bunzip2 -k FILE"},
    {"\xfd"
     "7zXZ",
     "is compressed with xz; decompress it first: unxz -k FILE"},
    {"\x28\xb5\x2f\xfd", "is compressed with zstd; decompress it first: unzstd FILE"},
    {"LASF", "is a LAS or LAZ file, which is not read; convert it: pdal translate FILE OUT.ply"},
    {"ASTM-E57", "is an E57 file, which is not read; convert it to PLY (CloudCompare, pdal)"},
    {"glTF", "is a glTF binary, which is not read; export it as PLY"},
    {"\xff\xfe", "is UTF-16 text; save it as UTF-8"},
    {"\xfe\xff", "is UTF-16 text; save it as UTF-8"},
};

bool has_ending(const Format& format, std::string_view ending) {
  return std::ranges::find(format.about.endings, ending) != format.about.endings.end();
}

// The content says nothing that would be enough: the ending must be true, or else all is a table of numbers.
const Format& format_by_ending(const Source& source) {
  const std::string ending = lower_ending(source.name());
  for (const Format& format : formats()) {
    if (format.read == nullptr || !has_ending(format, ending)) continue;
    if (format.may_be != nullptr && format.may_be(source.bytes())) return format;
    if (format.start == nullptr) continue;
    source.fail("ends in ." + ending + " but does not start as " + std::string(format.about.name) +
                " does, with '" + format.start + "'; export it again, or give it the ending of what it is");
  }
  for (const Format& format : formats()) {
    if (format.read == read_text && is_text(source.bytes())) return format;
  }
  source.fail("is in no format that is known; known are " + names_of_formats(FormatUse::ReadPoints));
}

template <class Has>
const Format* find_format(const Has& has) {
  const auto& all = formats();
  const auto found = std::ranges::find_if(all, has);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> table = make_formats();
  return table;
}

const Format& format_of(const Source& source) {
  for (const Refused& known : refused) {
    if (source.bytes().starts_with(known.start)) source.fail(known.message);
  }
  const Format* told =
      find_format([&](const Format& f) { return f.told != nullptr && f.told(source.bytes()); });
  return told != nullptr ? *told : format_by_ending(source);
}

const Format* mesh_format(std::string_view ending) {
  return find_format([&](const Format& f) { return f.about.mesh && f.about.mesh->ending == ending; });
}

const Format* loops_format(std::string_view ending) {
  return find_format([&](const Format& f) { return f.about.loops && f.about.loops->ending == ending; });
}

namespace {

// "a, b or c"
std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " or " : ", ";
    text += items[i];
  }
  return text;
}

}  // namespace
}  // namespace io

const std::vector<FileFormat>& file_formats() {
  static const std::vector<FileFormat> table = [] {
    std::vector<FileFormat> all;
    for (const io::Format& format : io::formats()) all.push_back(format.about);
    return all;
  }();
  return table;
}

bool serves(const FileFormat& format, FormatUse use) {
  switch (use) {
    case FormatUse::ReadPoints: return format.reading && format.reading->built;
    case FormatUse::ReadFaces: return format.reading && format.reading->built && format.reading->faces;
    case FormatUse::WriteMesh: return format.mesh.has_value();
    case FormatUse::WriteLoops: return format.loops.has_value();
  }
  return false;
}

std::string names_of_formats(FormatUse use) {
  std::vector<std::string> names;
  for (const FileFormat& format : file_formats()) {
    if (serves(format, use)) names.emplace_back(format.name);
  }
  return io::listed(names);
}

std::vector<std::string> written_endings(FormatUse use) {
  std::vector<std::string> endings;
  for (const FileFormat& format : file_formats()) {
    if (use == FormatUse::WriteMesh && format.mesh) endings.emplace_back(format.mesh->ending);
    if (use == FormatUse::WriteLoops && format.loops) endings.emplace_back(format.loops->ending);
  }
  return endings;
}

std::string text_of_endings(FormatUse use) {
  std::vector<std::string> endings = written_endings(use);
  for (std::string& ending : endings) ending = "." + ending;
  return io::listed(endings);
}

}  // namespace rimline
