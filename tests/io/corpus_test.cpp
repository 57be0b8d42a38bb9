// SPDX-License-Identifier: GPL-3.0-or-later
// The seeds of the fuzz targets, and inputs that once failed: read in every build, whatever the compiler.
#include <algorithm>
#include <cstdint>

#include "io/files.h"
#include "io/formats.h"

// Of fuzz/reconstruct.cpp, which is built here, too, so that it stays in step with the library.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace rimline {
namespace {

const std::filesystem::path corpus = std::filesystem::path(RIMLINE_SOURCE) / "fuzz/corpus";

std::vector<std::filesystem::path> seeds_of(const std::string& target) {
  std::vector<std::filesystem::path> seeds;
  if (!std::filesystem::is_directory(corpus / target)) return seeds;
  for (const auto& entry : std::filesystem::directory_iterator(corpus / target)) seeds.push_back(entry.path());
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

// Read by the readers of the format, or refused; returns whether it was read.
bool reads(const io::Format& format, const std::string& content) {
  const std::vector<char> exact(content.begin(), content.end());
  const io::Source source("seed." + std::string(format.about.endings[0]), std::string_view(exact.data(), exact.size()));
  try {
    const Cloud cloud = format.read(source, Run{});
    io::Faces faces(source, cloud.points.size());
    if (format.read_faces != nullptr) format.read_faces(source, cloud, faces);
    return !cloud.points.empty();
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::CannotRead);
    return false;
  }
}

TEST_CASE("every format that is read has a fuzz target with a seed that is read") {
  const std::string targets = content_of(std::string(RIMLINE_SOURCE) + "/fuzz/CMakeLists.txt");
  for (const io::Format& format : io::formats()) {
    if (format.read == nullptr) continue;
    const std::string target(format.about.endings[0]);
    CAPTURE(target);
    CHECK(contains(targets, " " + target));
    if (!RIMLINE_WITH_SCANS && (target == "las" || target == "e57")) {
      MESSAGE("skipped: built without the optional readers");
      continue;
    }
    std::size_t read = 0;
    for (const auto& seed : seeds_of(target)) read += reads(format, content_of(seed.string()));
    CHECK(read > 0);
  }
}

TEST_CASE("the seeds of the target any are told by their content alone") {
  for (const auto& seed : seeds_of("any")) {
    CAPTURE(seed.string());
    CHECK_NOTHROW(read_bytes("input", content_of(seed.string())));
  }
}

TEST_CASE("reconstruct takes the seeds of its fuzz target, whole and cut") {
  const auto seeds = seeds_of("reconstruct");
  REQUIRE(!seeds.empty());
  for (const auto& seed : seeds) {
    CAPTURE(seed.string());
    const std::string bytes = content_of(seed.string());
    for (std::size_t size = bytes.size();; size /= 2) {
      CHECK(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), size) == 0);
      if (size == 0) break;
    }
  }
}

}  // namespace
}  // namespace rimline
