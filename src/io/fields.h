// SPDX-License-Identifier: GPL-3.0-or-later
// Binary records with a declared layout (PLY, PCD) -> Cloud.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/lines.h"
#include "io/source.h"
#include "rimline/cloud.h"

namespace rimline::io {

// Scalar, and the two wide integers that some files have but PLY has not.
enum class FieldType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64, Int64, UInt64 };

std::size_t size_in_bytes(FieldType type);

// One number of every record.
struct Field {
  std::string name;
  FieldType type = FieldType::Float32;
  const char* first = nullptr;  // the value of record 0
  std::size_t stride = 0;       // bytes from one record to the next
};

// Throws CannotRead where the points are too many for an Index.
void check_point_count(const Source& source, std::uint64_t count);

// Points from the fields x, y, z (X, Y, Z where there are none; float only if all three are), columns from
// all others, in order. Int64 and UInt64 become double where no value loses by it, else two columns NAME_low
// and NAME_high (uint, int). The caller has checked that every field has `count` values.
Cloud cloud_from_fields(const std::vector<Field>& fields, std::size_t count, bool swap_bytes,
                        const Source& source, const Run& run);

// The numbers of one field, `stride` apart in `to`.
void values_of_field(const Field& field, std::size_t count, bool swap_bytes, double* to, std::size_t stride);

// Lays fields of the given names and types one after the other in records at `first`; returns their size.
std::size_t lay_out(std::vector<Field>& fields, const char* first);

// Reads one number of the type and stores it in native order; false where the row has none that fits.
bool read_value(Row& row, FieldType type, char* to);

// Names that are free for a PLY header: no blanks, no duplicates.
void make_names_usable(std::vector<Column>& columns);

}  // namespace rimline::io
