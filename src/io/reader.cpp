// SPDX-License-Identifier: GPL-3.0-or-later
// Which format is it?
#include <algorithm>
#include <array>
#include <cctype>
#include <new>
#include <optional>

#include "io/lines.h"
#include "io/readers.h"
#include "rimline/io.h"

namespace rimline {
namespace io {
namespace {

enum class Format { Ply, Text, Obj, Off, Pcd, StlAscii, StlBinary };

struct Magic {
  std::string_view start;
  const char* message;
};

// Files that are known, and known not to be readable.
constexpr Magic refused[] = {
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

std::string lower_ending(const std::string& name) {
  const std::size_t dot = name.find_last_of("./");
  if (dot == std::string::npos || name[dot] == '/') return {};
  std::string ending = name.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

// The first words of the first line that is neither blank nor a comment, within a few kilobytes.
std::string_view first_line(std::string_view start) {
  Lines lines(start);
  std::string_view line;
  return lines.next_filled(line, '#') ? line : std::string_view{};
}

bool is_obj_line(std::string_view line) {
  constexpr std::array<std::string_view, 12> keywords = {"v", "vn", "vt", "vp",     "f",      "l",
                                                         "p", "o",  "g",  "mtllib", "usemtl", "s"};
  Row row(line);
  const std::string_view keyword = row.word();
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end() && !row.done();
}

bool is_text(std::string_view start) {
  return std::none_of(start.begin(), start.end(), [](unsigned char c) {
    return c < 32 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
}

std::optional<Format> format_by_content(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 4096);
  if (start.starts_with("ply\n") || start.starts_with("ply\r")) return Format::Ply;
  if (start.starts_with("# .PCD")) return Format::Pcd;
  if (bytes.size() > 84 && is_stl_binary(bytes)) return Format::StlBinary;  // may start with "solid" too
  const std::string_view line = first_line(start);
  const std::string_view word = Row(line).word();
  if (word == "solid" && is_text(start)) return Format::StlAscii;
  if (word == "VERSION" || word == "FIELDS" || word == "COLUMNS") return Format::Pcd;
  if (word.size() <= 8 && word.ends_with("OFF")) return Format::Off;
  if (is_text(start) && is_obj_line(line)) return Format::Obj;
  return std::nullopt;
}

[[noreturn]] void fail_magic(const Source& source, const char* format, const char* magic) {
  source.fail("ends in ." + lower_ending(source.name()) + " but does not start as " + format +
              " does, with '" + magic + "'; export it again, or give it the ending of what it is");
}

Format format_by_ending(const Source& source) {
  const std::string ending = lower_ending(source.name());
  const bool text = is_text(source.bytes().substr(0, 4096));
  if (ending == "ply") fail_magic(source, "PLY", "ply");
  if (ending == "pcd") fail_magic(source, "PCD", "# .PCD");
  if (ending == "stl" && text) fail_magic(source, "an STL text", "solid");
  if (ending == "stl") return Format::StlBinary;
  if (ending == "off" && text) return Format::Off;  // the keyword may be left out
  if (ending == "obj" && text) return Format::Obj;
  if (text) return Format::Text;
  source.fail("is in no format that is known; known are PLY, XYZ/TXT/CSV, OBJ, OFF, PCD and STL");
}

const char* name(Format format) {
  switch (format) {
    case Format::Ply: return "PLY";
    case Format::Text: return "text";
    case Format::Obj: return "OBJ";
    case Format::Off: return "OFF";
    case Format::Pcd: return "PCD";
    case Format::StlAscii: return "STL, ascii";
    case Format::StlBinary: return "STL, binary";
  }
  return "?";
}

}  // namespace

Cloud read_any(const Source& source, const Run& run) {
  if (source.bytes().empty()) source.fail("is empty (0 bytes); copy or export it again");
  for (const Magic& magic : refused) {
    if (source.bytes().starts_with(magic.start)) source.fail(magic.message);
  }
  const auto known = format_by_content(source.bytes());
  const Format format = known ? *known : format_by_ending(source);
  const auto read = [&]() -> Cloud {
    switch (format) {
      case Format::Ply: return read_ply(source, run);
      case Format::Text: return read_text(source, run);
      case Format::Obj: return read_obj(source, run);
      case Format::Off: return read_off(source, run);
      case Format::Pcd: return read_pcd(source, run);
      case Format::StlAscii: return read_stl_ascii(source, run);
      case Format::StlBinary: return read_stl_binary(source, run);
    }
    return {};
  };
  Cloud cloud = read();
  if (cloud.format.empty()) cloud.format = name(format);  // PLY and PCD tell their kind themselves
  if (cloud.points.empty()) source.fail("has no points; export it again, with its vertices");
  source.progress(run, source.end());
  return cloud;
}

}  // namespace io

Cloud read_cloud(const std::string& path, const Run& run) {
  const io::Source source = io::load(path, run);
  try {
    return io::read_any(source, run);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::OutOfMemory,
                source.name() + ": its points do not fit into memory; thin the cloud");
  }
}

}  // namespace rimline
