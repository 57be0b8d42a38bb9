// SPDX-License-Identifier: GPL-3.0-or-later
// The table of file formats. Readers, writers, the tool's help, docs/formats.md and its test use it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rimline {

// How points are taken from a format. The texts are those of docs/formats.md.
struct ReadingFormat {
  std::string_view told_by;  // how the format is recognized: the first bytes, or the ending
  std::string_view points;   // what is read as a point
  std::string_view kept;     // what is read as a column
  bool faces = false;        // read_mesh takes its faces
  bool built = true;         // false where this build lacks the component that reads it
};

struct MeshFormat {
  std::string_view ending;    // lower case, without the dot
  std::string_view vertices;  // how points are written
  std::string_view beside;    // what is written beside them
};

struct LoopsFormat {
  std::string_view ending;
  std::string_view content;
};

struct FileFormat {
  std::string_view name;                  // "PLY"
  std::vector<std::string_view> endings;  // lower case, without the dot, the usual one first
  std::optional<ReadingFormat> reading = {};
  std::optional<MeshFormat> mesh = {};    // as written by write_mesh
  std::optional<LoopsFormat> loops = {};  // as written by write_loops
};

// All formats, in the order in which the content is tested.
const std::vector<FileFormat>& file_formats();

enum class FormatUse { ReadPoints, ReadFaces, WriteMesh, WriteLoops };

// Whether this build supports the format for that use.
bool serves(const FileFormat& format, FormatUse use);

// For people: "PLY, OBJ, OFF or STL".
std::string names_of_formats(FormatUse use);

// The endings that a written file may have (WriteMesh, WriteLoops): {"ply", "obj", ...}.
std::vector<std::string> written_endings(FormatUse use);

// For people: ".ply, .obj or .stl".
std::string text_of_endings(FormatUse use);

}  // namespace rimline
