// SPDX-License-Identifier: GPL-3.0-or-later
// Loops as lines for other programs: GeoJSON, WKT, CSV, PLY edges, OBJ lines, DXF.
#include <cmath>

#include "io/formats.h"
#include "rimline/io.h"

namespace rimline {
namespace io {
namespace {

struct LoopsFile {
  SafeFile& file;
  Points points;

  void point(Index id, char separator = ' ') { write_point(file, points[id], Scalar::Float64, separator); }
  void integer(std::size_t value) { file.number(static_cast<long long>(value)); }
};

std::size_t total_points(const std::vector<Loop>& loops) {
  std::size_t count = 0;
  for (const Loop& loop : loops) count += loop.points.size();
  return count;
}

void write_finite(SafeFile& file, double value) {
  std::isfinite(value) ? file.number(value) : file.write("null");
}

}  // namespace

void write_loops_json(SafeFile& file, const LoopsToWrite& what) {
  file.write(loops_to_json(what.loops, what.points.size()));
}

// Closed LineStrings of three coordinates, RFC 7946; the units are those of the input.
void write_loops_geojson(SafeFile& file, const LoopsToWrite& what) {
  LoopsFile out{file, what.points};
  const std::vector<Loop>& loops = what.loops;
  out.file.write("{\"type\": \"FeatureCollection\", \"features\": [");
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Loop& loop = loops[i];
    out.file.write(i == 0 ? "\n" : ",\n");
    out.file.write("{\"type\": \"Feature\", \"id\": " + std::to_string(i) +
                   ", \"properties\": {\"kind\": \"" + name(loop.kind) + "\", \"length\": ");
    write_finite(out.file, loop.length);
    out.file.write(", \"fitness\": ");
    write_finite(out.file, loop.fitness);
    out.file.write("}, \"geometry\": {\"type\": \"LineString\", \"coordinates\": [");
    for (std::size_t j = 0; j <= loop.points.size(); ++j) {
      out.file.write(j == 0 ? "[" : ", [");
      out.point(loop.points[j % loop.points.size()], ',');
      out.file.write(']');
    }
    out.file.write("]}}");
  }
  out.file.write("\n]}\n");
}

// One closed line string on each line of the file.
void write_loops_wkt(SafeFile& file, const LoopsToWrite& what) {
  LoopsFile out{file, what.points};
  const std::vector<Loop>& loops = what.loops;
  for (const Loop& loop : loops) {
    out.file.write("LINESTRING Z (");
    for (std::size_t j = 0; j <= loop.points.size(); ++j) {
      if (j > 0) out.file.write(", ");
      out.point(loop.points[j % loop.points.size()]);
    }
    out.file.write(")\n");
  }
}

void write_loops_csv(SafeFile& file, const LoopsToWrite& what) {
  LoopsFile out{file, what.points};
  const std::vector<Loop>& loops = what.loops;
  out.file.write("loop,kind,order,point,x,y,z\n");
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t j = 0; j < loops[i].points.size(); ++j) {
      out.integer(i);
      out.file.write(',');
      out.file.write(name(loops[i].kind));
      out.file.write(',');
      out.integer(j);
      out.file.write(',');
      out.integer(static_cast<std::size_t>(loops[i].points[j]));
      out.file.write(',');
      out.point(loops[i].points[j], ',');
      out.file.write('\n');
    }
  }
}

// Text PLY: the points of the loops with their ids, and the element `edge`.
void write_loops_edges(SafeFile& file, const LoopsToWrite& what) {
  LoopsFile out{file, what.points};
  const std::vector<Loop>& loops = what.loops;
  const std::string count = std::to_string(total_points(loops));
  out.file.write(
      "ply\nformat ascii 1.0\nelement vertex " + count +
      "\nproperty double x\nproperty double y\nproperty double z\nproperty int point\nproperty int loop\n" +
      "element edge " + count + "\nproperty int vertex1\nproperty int vertex2\nend_header\n");
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const Index id : loops[i].points) {
      out.point(id);
      out.file.write(' ');
      out.integer(static_cast<std::size_t>(id));
      out.file.write(' ');
      out.integer(i);
      out.file.write('\n');
    }
  }
  std::size_t first = 0;
  for (const Loop& loop : loops) {
    for (std::size_t j = 0; j < loop.points.size(); ++j) {
      out.integer(first + j);
      out.file.write(' ');
      out.integer(first + (j + 1) % loop.points.size());
      out.file.write('\n');
    }
    first += loop.points.size();
  }
}

void write_loops_obj(SafeFile& file, const LoopsToWrite& what) {
  LoopsFile out{file, what.points};
  const std::vector<Loop>& loops = what.loops;
  std::size_t first = 1;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    out.file.write("o " + std::string(name(loops[i].kind)) + "_" + std::to_string(i) + "\n");
    for (const Index id : loops[i].points) {
      out.file.write("v ");
      out.point(id);
      out.file.write('\n');
    }
    out.file.write('l');
    for (std::size_t j = 0; j <= loops[i].points.size(); ++j) {
      out.file.write(' ');
      out.integer(first + j % loops[i].points.size());
    }
    out.file.write('\n');
    first += loops[i].points.size();
  }
}

namespace {

void write_dxf_place(LoopsFile& out, Point p) {
  out.file.write("10\n");
  out.file.number(p.x);
  out.file.write("\n20\n");
  out.file.number(p.y);
  out.file.write("\n30\n");
  out.file.number(p.z);
  out.file.write('\n');
}

}  // namespace

// DXF R12, which every program reads: closed 3D polylines (70: 1 closed + 8 in space; vertices 32) on the
// layers OUTER and HOLE.
void write_loops_dxf(SafeFile& file, const LoopsToWrite& what) {
  LoopsFile out{file, what.points};
  const std::vector<Loop>& loops = what.loops;
  out.file.write("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
  for (const Loop& loop : loops) {
    const std::string layer = loop.kind == LoopKind::Outer ? "8\nOUTER\n" : "8\nHOLE\n";
    out.file.write("0\nPOLYLINE\n" + layer + "66\n1\n70\n9\n");
    write_dxf_place(out, {});
    for (const Index id : loop.points) {
      out.file.write("0\nVERTEX\n" + layer);
      write_dxf_place(out, out.points[id]);
      out.file.write("70\n32\n");
    }
    out.file.write("0\nSEQEND\n" + layer);
  }
  out.file.write("0\nENDSEC\n0\nEOF\n");
}

namespace {

std::string loops_ending(const std::string& path) {
  const bool no_ending = path.find('.', path.rfind('/') + 1) == std::string::npos;
  return no_ending && is_stream(path) ? "json" : ending_of(path);
}

}  // namespace
}  // namespace io

void check_loops_path(const std::string& path) {
  if (io::loops_format(io::loops_ending(path)) != nullptr) return;
  throw Error(ErrorCode::BadOption,
              path + ": the ending must be " + text_of_endings(FormatUse::WriteLoops) + " for loops");
}

void write_loops(const std::string& path, const std::vector<Loop>& loops, Points points, const Run& run) {
  check_loops_path(path);
  io::SafeFile file(path);
  run.progress(Stage::Write, 0, 1);
  io::loops_format(io::loops_ending(path))->write_loops(file, {loops, points});
  run.progress(Stage::Write, 1, 1);
  file.commit();
}

}  // namespace rimline
