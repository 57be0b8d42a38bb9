// SPDX-License-Identifier: GPL-3.0-or-later
// Files for the tests of io: made, read back, and gone at the end.
#pragma once

#include <doctest/doctest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "io/readers.h"
#include "rimline/cloud.h"
#include "rimline/io.h"

namespace rimline {

class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "rimline-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string file(const std::string& name, const std::string& content) const {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      result.push_back(entry.path().filename().string());
    }
    return result;
  }

 private:
  std::filesystem::path path_;
};

inline std::string content_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Reads a file of that name and content, from a block of exactly that size, so that a sanitizer sees a step
// beyond its end.
inline Cloud read_bytes(const std::string& name, const std::string& content, const Run& run = {}) {
  const std::vector<char> exact(content.begin(), content.end());
  return io::read_any(io::Source(name, std::string_view(exact.data(), exact.size())), run);
}

// The message of the Error{CannotRead} that reading throws; fails the test where it throws none.
inline std::string complaint(const std::string& name, const std::string& content) {
  try {
    read_bytes(name, content);
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::CannotRead);
    return error.what();
  }
  FAIL_CHECK("was read: " << content.substr(0, 100));
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::vector<double> values(const Cloud& cloud, const std::string& name) {
  const Column* column = cloud.find(name);
  REQUIRE_MESSAGE(column != nullptr, name);
  std::vector<double> result;
  for (Index i = 0; i < static_cast<Index>(cloud.points.size()); ++i) result.push_back(column->value(i));
  return result;
}

// The bytes of numbers, in the order of this machine or turned.
template <class T>
std::string bytes_of(T value, bool turned = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return turned ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

}  // namespace rimline
