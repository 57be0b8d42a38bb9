// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/source.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "io/gzip.h"

namespace rimline::io {
namespace {

constexpr std::size_t bytes_per_read = std::size_t{1} << 24;

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ > STDERR_FILENO) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }

 private:
  int value_;
};

[[noreturn]] void cannot_read(const std::string& name, const std::string& message) {
  throw Error(ErrorCode::CannotRead, name + ": " + message);
}

int open_for_reading(const std::string& path) {
  if (path == "-") return STDIN_FILENO;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  if (errno == ENOENT) cannot_read(path, "there is no such file; check the path");
  if (errno == EACCES) cannot_read(path, "permission denied; make the file readable");
  cannot_read(path, std::string("cannot be opened: ") + std::strerror(errno) +
                        "; check the path and its permissions");
}

// A pipe may stay silent for long; waiting in slices lets a cancel through.
void wait_for_bytes(int descriptor, const Run& run) {
  pollfd waiting{descriptor, POLLIN, 0};
  while (::poll(&waiting, 1, 100) == 0) run.check_cancel();
  run.check_cancel();
}

// Reads until `room` bytes are there or the input ends.
std::size_t read_up_to(int descriptor, char* to, std::size_t room, const std::string& name, const Run& run) {
  std::size_t have = 0;
  while (have < room) {
    wait_for_bytes(descriptor, run);
    const ssize_t got = ::read(descriptor, to + have, std::min(room - have, bytes_per_read));
    if (got == 0) break;
    if (got > 0) have += static_cast<std::size_t>(got);
    if (got < 0 && errno == EISDIR) cannot_read(name, "is a directory; name a file in it");
    if (got < 0 && errno != EINTR && errno != EAGAIN) {
      cannot_read(name, "reading stopped at byte " + std::to_string(have) + ": " + std::strerror(errno) +
                            "; copy the file to another place and read it there");
    }
  }
  return have;
}

void check_limit(std::size_t size, const std::string& name, const Run& run) {
  if (run.memory_limit == 0 || size <= run.memory_limit) return;
  throw Error(ErrorCode::OutOfMemory,
              name + ": has " + std::to_string(size) + " bytes, more than the memory limit of " +
                  std::to_string(run.memory_limit) + "; raise the limit or thin the cloud");
}

// The size is not known: the buffer doubles as bytes come in.
Source load_stream(int descriptor, const std::string& name, const Run& run) {
  std::size_t room = std::size_t{1} << 16, size = 0;
  auto storage = std::make_unique_for_overwrite<char[]>(room);
  for (;;) {
    size += read_up_to(descriptor, storage.get() + size, room - size, name, run);
    run.progress(Stage::Read, 0, 0);
    check_limit(size < room ? size : 2 * room, name, run);
    if (size < room) return Source(name, std::move(storage), size);
    auto larger = std::make_unique_for_overwrite<char[]>(2 * room);
    std::memcpy(larger.get(), storage.get(), size);
    storage = std::move(larger);
    room *= 2;
  }
}

Source load_file(int descriptor, std::size_t size, const std::string& name, const Run& run) {
  // Not memory-mapped: a file truncated meanwhile by another program would end the process with a signal.
  auto storage = std::make_unique_for_overwrite<char[]>(size);
  std::size_t have = 0;
  while (have < size) {
    run.progress(Stage::Read, have, 2 * size);
    const std::size_t room = std::min(size - have, bytes_per_read);
    const std::size_t got = read_up_to(descriptor, storage.get() + have, room, name, run);
    have += got;
    if (got < room) break;
  }
  return Source(name, std::move(storage), have);
}

// The remedy, after a semicolon, where the message has none.
std::string with_remedy(const std::string& message, const char* remedy) {
  return message.find(';') != std::string::npos ? message : message + "; " + remedy;
}

std::string at(const std::string& name, const char* unit, std::size_t number, const std::string& message) {
  return name + ", " + unit + " " + std::to_string(number) + ": " +
         with_remedy(message, "correct that place, or export the file again");
}

}  // namespace

std::string_view Source::without_mark(std::string_view bytes) {
  constexpr std::size_t looked_at = 96;  // a binary STL has zeros there
  const bool is_text = bytes.substr(0, looked_at).find('\0') == std::string_view::npos;
  if (is_text && bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  return bytes;
}

void Source::progress(const Run& run, std::size_t done, std::size_t total) const {
  run.progress(Stage::Read, total + done, 2 * total);
}

void Source::fail(const std::string& message) const {
  cannot_read(name_, with_remedy(message, "export the file again"));
}

void Source::fail_at_line(const char* where, const std::string& message) const {
  const char newline = bytes_.find('\n') == std::string_view::npos ? '\r' : '\n';
  const auto line = 1 + static_cast<std::size_t>(std::count(begin(), where, newline));
  throw Error(ErrorCode::CannotRead, at(name_, "line", line, message));
}

void Source::fail_at_byte(const char* where, const std::string& message) const {
  throw Error(ErrorCode::CannotRead, at(name_, "byte", static_cast<std::size_t>(where - begin()), message));
}

Source load(const std::string& path, const Run& run) {
  const std::string name = path == "-" ? "standard input" : path;
  try {
    const Descriptor descriptor(open_for_reading(path));
    struct stat status {};
    if (::fstat(descriptor.value(), &status) != 0) cannot_read(name, std::strerror(errno));
    if (S_ISDIR(status.st_mode)) cannot_read(name, "is a directory; name a file in it");
    check_limit(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)), name, run);
    // Standard input may stand in the middle of a file, and files of the kernel say 0.
    const bool sized = S_ISREG(status.st_mode) && status.st_size > 0 && path != "-";
    Source source = sized ? load_file(descriptor.value(), static_cast<std::size_t>(status.st_size), name, run)
                          : load_stream(descriptor.value(), name, run);
    return is_gzip(source.bytes()) ? unpack_gzip(source, run) : std::move(source);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::OutOfMemory, name + ": does not fit into memory; read a part of it");
  }
}

std::string quoted(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string result = "'";
  for (const char c : text.substr(0, most)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 32 || byte == 127 ? '?' : c;
  }
  return result + (text.size() > most ? "...'" : "'");
}

}  // namespace rimline::io
