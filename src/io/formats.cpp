// SPDX-License-Identifier: GPL-3.0-or-later
// Lookups in the table of formats.
#include "io/formats.h"

#include <algorithm>
#include <array>

#include "io/telling.h"

namespace rimline {
namespace io {
namespace {

// Known formats that can not be read.
struct Refused {
  std::string_view start;
  const char* message;
};

constexpr Refused refused[] = {
    {"\x1f\x8b", "is compressed with gzip twice; unpack it once: gunzip -k FILE"},
    {"PK\x03\x04", "is a zip archive; unpack it first: unzip FILE"},
    {"BZh", "is compressed with bzip2; decompress it first: bunzip2 -k FILE"},
    {"\xfd"
     "7zXZ",
     "is compressed with xz; decompress it first: unxz -k FILE"},
    {"\x28\xb5\x2f\xfd", "is compressed with zstd; decompress it first: unzstd FILE"},
    {"\xff\xfe", "is UTF-16 text; save it as UTF-8"},
    {"\xfe\xff", "is UTF-16 text; save it as UTF-8"},
};

bool has_ending(const Format& format, std::string_view ending) {
  return std::ranges::find(format.about.endings, ending) != format.about.endings.end();
}

// Of the packed file, if packed: scan.csv.gz holds a csv.
std::string ending_inside(const Source& source) {
  const std::string ending = lower_ending(source.name());
  if (source.packing().empty() || ending != "gz") return ending;
  return lower_ending(std::string_view(source.name()).substr(0, source.name().size() - 3));
}

// The content is not conclusive: the ending decides, else the file is a table of numbers.
const Format& format_by_ending(const Source& source) {
  if (is_utf16(source.bytes())) source.fail("is UTF-16 text; save it as UTF-8");
  const std::string ending = ending_inside(source);
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
