// SPDX-License-Identifier: GPL-3.0-or-later
// A file that is written completely or not at all.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rimline::io {

// Written beside its target (as .NAME.rimline-PID-N.tmp) and renamed over it by commit(); without a commit
// the target is untouched and nothing is left. Links are followed, also to a file that is not there yet; a
// file that is replaced hands down its owner and mode. "-" is standard output; it, devices and pipes are
// written to directly. All functions throw Error{CannotWrite} with the system's reason.
class SafeFile {
 public:
  explicit SafeFile(std::string path);
  ~SafeFile();
  SafeFile(const SafeFile&) = delete;
  SafeFile& operator=(const SafeFile&) = delete;

  void write(std::string_view bytes);
  void write(char c) { write(std::string_view(&c, 1)); }
  // A number as text, in the shortest form that reads back as the same number.
  void number(double value);
  void number(float value);
  void number(long long value);
  // A number as bytes, little-endian.
  template <class T>
  void little(T value);

  void commit();

  // As messages name it.
  std::string name() const;

 private:
  void open_temporary(unsigned mode);
  void flush();
  void write_through(const char* from, std::size_t size);
  char* room(std::size_t size) {
    if (buffer_.size() - used_ < size) flush();
    return buffer_.data() + used_;
  }
  [[noreturn]] void fail(const std::string& action) const;

  void forget_temporary();

  std::string path_, target_, temporary_;  // as given; links followed; what is open now, if renamed later
  int descriptor_ = -1;
  int slot_ = -1;  // of temporary_ in the list for remove_unfinished_files()
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

template <class T>
void SafeFile::little(T value) {
  static_assert(std::is_arithmetic_v<T>);
  char* to = room(sizeof(T));
  std::memcpy(to, &value, sizeof(T));
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(to[i], to[sizeof(T) - 1 - i]);
#endif
  used_ += sizeof(T);
}

}  // namespace rimline::io
