// SPDX-License-Identifier: GPL-3.0-or-later
// LAS, LAZ, COPC and E57 by the Rust crates las, laz and e57. Nothing here throws, prints or ends the
// process; messages are sentences without the name of the file, cut to their room.
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct RimlineScan RimlineScan;

// The types of columns.
enum {
  rimline_scan_uint8,
  rimline_scan_int16,
  rimline_scan_uint16,
  rimline_scan_int32,
  rimline_scan_uint32,
  rimline_scan_float32,
  rimline_scan_float64
};

// Looks at a file that starts with LASF or ASTM-E57. `bytes` must stay until rimline_scan_close. NULL, with a
// message, where it can not be read.
RimlineScan* rimline_scan_open(const uint8_t* bytes, size_t size, char* message, size_t room);

// Points that the file announces; checked: no more than 64 a byte of the file.
uint64_t rimline_scan_points(const RimlineScan* scan);

// "LAZ 1.4, point format 7"; "m", or "" where the unit is not known. They live as long as the scan.
const char* rimline_scan_format(const RimlineScan* scan);
const char* rimline_scan_unit(const RimlineScan* scan);

// What stands beside x, y and z.
size_t rimline_scan_columns(const RimlineScan* scan);
const char* rimline_scan_column_name(const RimlineScan* scan, size_t column);
uint8_t rimline_scan_column_kind(const RimlineScan* scan, size_t column);

// The next points, at most `most`: x, y, z and the columns, point after point, valid until the next call.
// Returns their number, 0 at the end, -1 with a message where the file is wrong.
int64_t rimline_scan_read(RimlineScan* scan, size_t most, const double** rows, char* message, size_t room);

void rimline_scan_close(RimlineScan* scan);

#ifdef __cplusplus
}
#endif
