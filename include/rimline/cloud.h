// SPDX-License-Identifier: GPL-3.0-or-later
// A point cloud as a file holds it: the points, and whatever else each of them carries.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rimline/given.h"
#include "rimline/points.h"

namespace rimline {

// The scalar types of PLY; the types of all other formats fit into them.
enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::size_t size_in_bytes(Scalar type);
// PLY's name of the type: "uchar", "double", ...
const char* name(Scalar type);

// One property of every point (a colour channel, an intensity, ...), kept byte for byte in native order.
struct Column {
  std::string name;
  Scalar type = Scalar::Float64;
  std::vector<std::byte> bytes;  // size_in_bytes(type) per point

  // The value of a point as a double; integers of all types and floats convert without loss.
  double value(Index point) const;
};

// Makes a column from numbers: T is one of std::int8_t, uint8_t, int16_t, uint16_t, int32_t, uint32_t, float
// and double.
template <class T>
Column make_column(std::string name, const std::vector<T>& values);

struct Cloud {
  std::vector<Point> points;
  Scalar coordinate_type = Scalar::Float64;  // Float32 where the file stores floats: written back as such
  std::vector<Column> columns;               // all other properties, in the order of the file
  // A description of the file; each may be empty.
  std::string format = {};       // "PLY, ascii"
  std::string coordinates = {};  // what became x, y and z: "Easting, Northing, Height (columns 2, 3, 4)"
  std::string unit = {};         // unit of the coordinates, where the file names one: "m"
  std::vector<std::string> warnings = {};  // guesses made by the reader, and other remarks

  // The column of that name, or nullptr.
  const Column* find(std::string_view name) const;
  // One normal per point from the columns nx, ny, nz; empty where the cloud has none.
  std::vector<Point> normals() const;
  // One cell per point from the columns `column` and `row`; empty where the cloud lacks one of these, a value is
  // no id from 0, or the column `scan` tells of several scans.
  std::vector<RasterCell> raster() const;
};

// Appends the column, or puts it in the place of the one with the same name.
void set_column(Cloud& cloud, Column column);

}  // namespace rimline
