// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the table of formats.
#include "io/formats.h"
#include "io/telling.h"

namespace rimline::io {
namespace {

#ifdef RIMLINE_HAS_SCAN_FORMATS
constexpr bool has_scan_formats = true;
#else
constexpr bool has_scan_formats = false;
#endif

bool is_not_text(std::string_view bytes) { return !is_text(bytes); }
bool is_las(std::string_view bytes) { return bytes.starts_with("LASF"); }
bool is_e57(std::string_view bytes) { return bytes.starts_with("ASTM-E57"); }

}  // namespace

#ifndef RIMLINE_HAS_SCAN_FORMATS
Cloud read_scan(const Source& source, const Run&) {
  source.fail(
      "is LAS, LAZ, COPC or E57, which this rimline was built without; build it where there is cargo "
      "(scripts/setup), or convert the file to PLY");
}
#endif

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
      {.about =
           {.name = "STL",
            .endings = {"stl"},
            .reading = {{.told_by = "`solid`, or a size that fits its count",
                         .points = "the corners; equal ones become one point, in order of appearance",
                         .kept = "nothing",
                         .faces = true}},
            .mesh = {{"stl", "corners of triangles, as floats",
                      "normals of the triangles. Where 32 bits can not hold the coordinates, an offset is "
                      "taken off all, which the header (`add X Y Z`), the summary and the report "
                      "(`mesh.offset`) name"}}},
       .told = tells_stl,
       .may_be = is_not_text,
       .start = "solid",
       .read = read_stl,
       .read_faces = read_stl_faces,
       .write_mesh = write_stl},
      {.about = {.name = "PCD",
                 .endings = {"pcd"},
                 .reading = {{.told_by = "`# .PCD`, `VERSION`, `FIELDS`",
                              .points = "fields `x`, `y`, `z`, in any case",
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
                           "colours after `v x y z`, from 0 to 1; `vt` where there are `u` and `v`; `vn`, "
                           "the input's or else those of the mesh; "
                           "the three share their numbers, but for further `vt` of points on seams. With "
                           "`--texture-size` a `.mtl` and a `.png` beside it. NaN is written as 0 in `vt` "
                           "and `vn`; points "
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
                 .reading = {{.told_by = "`glTF`",
                              .points = "`POSITION` of all that the scene shows, each at its node's place",
                              .kept =
                                  "`NORMAL` as `nx ny nz`, `COLOR_0` as uchar `red green blue`, where all "
                                  "have them",
                              .faces = true}},
                 .mesh = {{"glb",
                           "all points, in order, as floats about the middle of the box of the triangles; "
                           "the middle, in "
                           "double, is the node's translation",
                           "`NORMAL` (the input's or those of the mesh), `TEXCOORD_0` (`u`, `1 - v`, as glTF "
                           "counts v downwards), `COLOR_0` from `red green blue`, `_POINT` with the id of "
                           "the point (beyond 2^24 as two numbers, the second counting these): points on "
                           "seams have further vertices, after all points. Points without a "
                           "place that a float holds are put in the middle and are in no triangle. The "
                           "material is seen "
                           "from both sides; with `--texture-size` it has a picture in place of `COLOR_0`. "
                           "Axes are not turned; `asset.extras` says so, and the unit"}}},
       .told = is_glb,
       .start = "glTF",
       .read = read_glb,
       .read_faces = read_glb_faces,
       .write_mesh = write_glb},
      {.about =
           {.name = "LAS/LAZ/COPC",
            .endings = {"las", "laz"},
            .reading = {{.told_by = "`LASF`",
                         .points = "the records of versions 1.0 to 1.4, compressed or not, by scale and "
                                   "offset in double",
                         .kept = "`intensity`, `return_number`, `number_of_returns`, `classification`, "
                                 "`scan_angle` (degrees), `user_data`, `point_source_id`, `gps_time`, "
                                 "ushort `red green blue`, `nir`; the flags `scan_direction_flag`, "
                                 "`edge_of_flight_line`, `synthetic`, `key_point`, `withheld`, from format 6 "
                                 "`overlap` and `scanner_channel`; extra bytes that the file describes, by "
                                 "scale and offset where it has them (64-bit integers as double). Waveforms "
                                 "are not kept",
                         .built = has_scan_formats}}},
       .told = is_las,
       .start = "LASF",
       .read = read_scan},
      {.about = {.name = "E57",
                 .endings = {"e57"},
                 .reading = {{.told_by = "`ASTM-E57`",
                              .points = "the points of all scans, cartesian or spherical, each moved by its "
                                        "pose; those marked invalid have no place (NaN)",
                              .kept =
                                  "`intensity`, `red green blue`, `time`, `row` and `column` of the scan's "
                                  "raster, `number_of_returns`, `return_number`, `nx ny nz`, any extension; "
                                  "`scan`, where there are several",
                              .built = has_scan_formats}}},
       .told = is_e57,
       .start = "ASTM-E57",
       .read = read_scan},
      {.about = {.name = "NPY",
                 .endings = {"npy"},
                 .reading = {{.told_by = "`\\x93NUMPY`",
                              .points = "rows of three columns or more (any axes before the last), or fields "
                                        "`x`, `y`, `z`",
                              .kept = "every other column, named as in a table without a header, or field"}}},
       .told = is_npy,
       .start = "\\x93NUMPY",
       .read = read_npy},
      {.about =
           {.name = "PTX",
            .endings = {"ptx"},
            .reading = {{.told_by = "two lines of one number, four of three, four of four",
                         .points = "the cells of all scans, each moved by its scan's matrix; a cell that "
                                   "saw nothing (0 0 0) has no place (NaN)",
                         .kept = "`intensity`; uchar `red green blue`; `scan`, `column` and `row` in the "
                                 "scan's raster"}}},
       .told = is_ptx,
       .start = "the number of columns",
       .read = read_ptx},
      {.about = {.name = "XYZ/TXT/CSV",
                 .endings = {"xyz", "txt", "csv", "pts", "asc"},
                 .reading = {{.told_by = "nothing else fits, and it is text",
                              .points = "columns `x`, `y`, `z` or of names that mean them, or the "
                                        "first three, or those after a counting one",
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

}  // namespace rimline::io
