// SPDX-License-Identifier: GPL-3.0-or-later
// A row of the table of formats, with the functions that read and write it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/readers.h"
#include "io/writers.h"
#include "rimline/formats.h"

namespace rimline::io {

struct Format {
  FileFormat about;
  // Whether the content has this format. `bytes`: the whole file.
  bool (*told)(std::string_view bytes) = nullptr;
  // For inconclusive content: whether a file of that ending may have this format. Without it the ending must
  // be wrong, and `start` describes what the file should begin with.
  bool (*may_be)(std::string_view bytes) = nullptr;
  const char* start = nullptr;
  Cloud (*read)(const Source&, const Run&) = nullptr;
  void (*read_faces)(const Source&, const Cloud&, Faces&) = nullptr;
  Point (*write_mesh)(SafeFile&, const MeshToWrite&, const Run&) = nullptr;
  void (*write_loops)(SafeFile&, const LoopsToWrite&) = nullptr;
};

// The table; format_table.cpp.
std::vector<Format> make_formats();
const std::vector<Format>& formats();

// The format of a source by its content, then its ending. Throws CannotRead with what to do where it is none
// that can be read.
const Format& format_of(const Source& source);

// The format that writes a file of that ending, or nullptr.
const Format* mesh_format(std::string_view ending);
const Format* loops_format(std::string_view ending);

}  // namespace rimline::io
