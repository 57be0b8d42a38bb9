// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of an input, and errors at positions in it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "rimline/run.h"

namespace rimline::io {

// How many items are handled between two looks at Run: short enough for a tenth of a second anywhere.
inline constexpr std::size_t items_per_look = 65536;

class Source {
 public:
  // Bytes that the caller keeps alive.
  Source(std::string name, std::string_view bytes) : name_(std::move(name)), bytes_(without_mark(bytes)) {}
  Source(std::string name, std::unique_ptr<char[]> storage, std::size_t size)
      : name_(std::move(name)), storage_(std::move(storage)), bytes_(without_mark({storage_.get(), size})) {}

  const std::string& name() const { return name_; }
  // How the file was packed ("gzip"); empty where these are its own bytes.
  const std::string& packing() const { return packing_; }
  void set_packing(std::string packing) { packing_ = std::move(packing); }
  std::string_view bytes() const { return bytes_; }
  const char* begin() const { return bytes_.data(); }
  const char* end() const { return bytes_.data() + bytes_.size(); }
  std::size_t bytes_from(const char* at) const { return static_cast<std::size_t>(end() - at); }

  // Loading is the first half of Stage::Read, parsing the second: `done` of `total` items are parsed.
  void progress(const Run& run, std::size_t done, std::size_t total) const;
  void progress(const Run& run, const char* at) const {
    progress(run, static_cast<std::size_t>(at - begin()), bytes_.size());
  }

  // All throw Error{CannotRead} with "NAME: ...", "NAME, line 7: ..." or "NAME, byte 123: ...". What to do
  // stands after a semicolon; a message without one gets a general remedy.
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_at_line(const char* at, const std::string& message) const;
  [[noreturn]] void fail_at_byte(const char* at, const std::string& message) const;

 private:
  // Text may start with the byte order mark of UTF-8, which says nothing.
  static std::string_view without_mark(std::string_view bytes);

  std::string name_, packing_;
  std::unique_ptr<char[]> storage_;
  std::string_view bytes_;
};

// Loads a whole file, or standard input for "-", and unpacks it where it is gzip. Throws CannotRead,
// OutOfMemory, Cancelled.
Source load(const std::string& path, const Run& run);

// Text from the input, fit to be quoted in a message: cut short, without control characters.
std::string quoted(std::string_view text);

}  // namespace rimline::io
