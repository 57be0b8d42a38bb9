// SPDX-License-Identifier: GPL-3.0-or-later
// Text, line by line and value by value.
#pragma once

#include <cstring>
#include <string_view>

#include "base/parse.h"

namespace rimline::io {

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

inline const char* skip_blanks(const char* at, const char* end) {
  while (at < end && is_blank(*at)) ++at;
  return at;
}

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '\r')) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

// The values of one line, parted by blanks.
class Row {
 public:
  explicit Row(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) { skip(); }

  bool done() const { return at_ == end_; }
  const char* at() const { return at_; }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  template <class T>
  bool read(T& value) {
    const char* after = read_number(at_, end_, value);
    if (after == nullptr || (after != end_ && !is_blank(*after))) return false;
    at_ = after;
    skip();
    return true;
  }

  // The next run of characters that are not blank; empty at the end.
  std::string_view word() {
    const char* first = at_;
    while (at_ < end_ && !is_blank(*at_)) ++at_;
    const std::string_view result(first, static_cast<std::size_t>(at_ - first));
    skip();
    return result;
  }

 private:
  void skip() { at_ = skip_blanks(at_, end_); }

  const char* at_;
  const char* end_;
};

// Lines that end with LF, CR LF, or (where there is no LF at all) CR.
class Lines {
 public:
  explicit Lines(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {
    newline_ =
        text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos ? '\r' : '\n';
  }

  // Gives the next line without its end; false after the last one.
  bool next(std::string_view& line) {
    if (at_ == end_) return false;
    const auto* stop =
        static_cast<const char*>(std::memchr(at_, newline_, static_cast<std::size_t>(end_ - at_)));
    if (stop == nullptr) stop = end_;
    const char* last = stop > at_ && stop[-1] == '\r' ? stop - 1 : stop;
    line = {at_, static_cast<std::size_t>(last - at_)};
    at_ = stop == end_ ? end_ : stop + 1;
    return true;
  }

  // The next line that is neither blank nor a comment.
  bool next_filled(std::string_view& line, char comment = '\0') {
    while (next(line)) {
      const char* first = skip_blanks(line.data(), line.data() + line.size());
      if (first != line.data() + line.size() && (comment == '\0' || *first != comment)) return true;
    }
    return false;
  }

  const char* at() const { return at_; }

 private:
  const char* at_;
  const char* end_;
  char newline_;
};

}  // namespace rimline::io
