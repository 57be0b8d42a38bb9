// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes given to the readers of one format, the one that has the ending RIMLINE_ENDING: they give a whole
// cloud and faces of its points, or say CannotRead.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "e57_pages.h"
#include "io/formats.h"
#include "whole.h"

namespace {

using namespace rimline;

const io::Format& format_under_test() {
  for (const io::Format& format : io::formats()) {
    if (format.read != nullptr && std::ranges::count(format.about.endings, RIMLINE_ENDING) > 0) return format;
  }
  std::abort();  // no such format
}

void check_faces(const io::Format& format, const io::Source& source, const Cloud& cloud) {
  if (format.read_faces == nullptr) return;
  io::Faces faces(source, cloud.points.size());
  format.read_faces(source, cloud, faces);
  for (const Triangle& t : faces.triangles) {
    for (const Index id : t) {
      if (id < 0 || id >= static_cast<Index>(cloud.points.size())) std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const io::Format& format = format_under_test();
  if (size == 0) return 0;  // refused before a reader is chosen
  std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::string mended;
  if (std::string_view(RIMLINE_ENDING) == "e57") bytes = mended = fuzz::with_checksums(std::string(bytes));
  const io::Source source("input." RIMLINE_ENDING, bytes);
  try {
    const Cloud cloud = format.read(source, Run{});
    fuzz::check_whole(cloud);
    check_faces(format, source, cloud);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::CannotRead) std::abort();
  }
  return 0;
}
