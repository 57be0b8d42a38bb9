// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/safe_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <utility>

#include "rimline/io.h"

namespace rimline {
namespace io {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;

std::string directory_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

// The real path of what is there; `path` itself for a pipe, whose link under /proc leads nowhere.
std::string real_path(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? real.get() : path;
}

// Where a link points to, one step on; empty where `path` is no link.
std::string link_target(const std::string& path) {
  std::array<char, 4096> text;  // PATH_MAX
  const ssize_t size = ::readlink(path.c_str(), text.data(), text.size());
  if (size <= 0 || static_cast<std::size_t>(size) == text.size()) return {};
  std::string target(text.data(), static_cast<std::size_t>(size));
  return target.front() == '/' ? target : directory_of(path) + "/" + target;
}

// The remedy where the system refuses an output for that reason.
const char* remedy_of(int reason) {
  switch (reason) {
    case ENOSPC:
    case EDQUOT: return "free some space or write elsewhere";
    case EFBIG: return "raise the limit on the size of files (ulimit -f) or write elsewhere";
    case EPIPE: return "what reads it has ended";
    case EISDIR: return "name a file in it";
    case ENAMETOOLONG: return "give it a shorter name";
    default: return "check the path and its permissions, or write elsewhere";
  }
}

// The descriptor, with another number where it has that of a standard stream that was closed: what is printed
// must not reach an output.
int above_standard(int descriptor) {
  if (descriptor < 0 || descriptor > STDERR_FILENO) return descriptor;
  const int above = ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return above;
}

int open_file(const std::string& path, int flags, mode_t mode = 0) {
  return above_standard(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, mode));
}

// Gives a new file the owner and the mode of the one that it will replace. Where the owner can not be kept
// (only root may give files away), nobody gains rights by it: no bit to run as the owner stays.
void keep_owner_and_mode(int descriptor, const struct stat& old) {
  const bool group = ::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) == 0;
  const bool owner = ::fchown(descriptor, old.st_uid, static_cast<gid_t>(-1)) == 0;
  (void)::fchmod(descriptor, old.st_mode & (owner && group ? 07777 : 0777));
}

std::string temporary_name(const std::string& target, int attempt) {
  const std::size_t slash = target.rfind('/');
  const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
  // Names of up to 255 bytes are allowed: leave room for what is added.
  return target.substr(0, start) + "." + target.substr(start, 200) + ".rimline-" +
         std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
}

template <class T>
std::size_t print(char* to, std::size_t size, T value) {
  return static_cast<std::size_t>(std::to_chars(to, to + size, value).ptr - to);
}

constexpr std::size_t longest_number = 32;

// The temporary files that are open, where a signal handler can find them: fixed memory, no locks. A file
// beyond the last slot is not listed; the tool writes one at a time.
struct Slot {
  std::atomic<bool> taken{false}, filled{false};
  std::array<char, 4096> name{};  // PATH_MAX
};
std::array<Slot, 16> unfinished;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

// The slot's number, or -1.
int list_unfinished(const std::string& name) {
  if (name.size() >= Slot{}.name.size()) return -1;
  for (std::size_t i = 0; i < unfinished.size(); ++i) {
    if (unfinished[i].taken.exchange(true)) continue;
    std::memcpy(unfinished[i].name.data(), name.c_str(), name.size() + 1);
    unfinished[i].filled = true;
    return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

SafeFile::SafeFile(std::string path) : path_(std::move(path)), buffer_(buffer_size) {
  if (path_ == "-") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  target_ = follow_links(path_);
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    fail("cannot be written");
  }
  if (exists && !S_ISREG(status.st_mode)) {  // /dev/null must not be replaced by a file
    descriptor_ = open_file(target_, 0);
    if (descriptor_ < 0) fail("cannot be opened");
    return;
  }
  open_temporary(exists ? 0600 : 0666);  // the old file's content must not become readable
  if (exists) keep_owner_and_mode(descriptor_, status);
}

void SafeFile::open_temporary(unsigned mode) {
  constexpr int most_attempts = 1000;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    temporary_ = temporary_name(target_, attempt);
    descriptor_ = open_file(temporary_, O_CREAT | O_EXCL, mode);
    if (descriptor_ >= 0) {
      slot_ = list_unfinished(temporary_);
      return;
    }
    if (errno != EEXIST) break;
  }
  temporary_.clear();
  if (errno == ENOENT) {
    throw Error(ErrorCode::CannotWrite,
                path_ + ": its directory '" + directory_of(target_) + "' does not exist; create it first");
  }
  fail("cannot be created in '" + directory_of(target_) + "'");
}

SafeFile::~SafeFile() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  forget_temporary();
}

void SafeFile::forget_temporary() {
  temporary_.clear();
  if (slot_ < 0) return;
  unfinished[slot_].filled = false;
  unfinished[slot_].taken = false;
  slot_ = -1;
}

std::string SafeFile::name() const { return path_ == "-" ? "standard output" : path_; }

void SafeFile::fail(const std::string& action) const {
  const int reason = errno;
  throw Error(ErrorCode::CannotWrite,
              name() + ": " + action + ": " + std::strerror(reason) + "; " + remedy_of(reason));
}

void SafeFile::write_through(const char* from, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, from, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("writing stopped");
    from += written;
    size -= static_cast<std::size_t>(written);
  }
}

void SafeFile::flush() {
  write_through(buffer_.data(), used_);
  used_ = 0;
}

void SafeFile::write(std::string_view bytes) {
  if (bytes.size() > buffer_.size() / 4) {
    flush();
    write_through(bytes.data(), bytes.size());
    return;
  }
  if (bytes.empty()) return;
  std::memcpy(room(bytes.size()), bytes.data(), bytes.size());
  used_ += bytes.size();
}

void SafeFile::number(double value) {
  char* to = room(longest_number);
  used_ += print(to, longest_number, value);
}
void SafeFile::number(float value) {
  char* to = room(longest_number);
  used_ += print(to, longest_number, value);
}
void SafeFile::number(long long value) {
  char* to = room(longest_number);
  used_ += print(to, longest_number, value);
}

void SafeFile::commit() {
  flush();
  if (descriptor_ > STDERR_FILENO) {
    const int closed = ::close(std::exchange(descriptor_, -1));
    if (closed != 0) fail("writing stopped");  // some file systems say only now that the disk is full
  }
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot be replaced");
  forget_temporary();
}

}  // namespace io

bool is_stream(const std::string& path) {
  struct stat status {};
  return path == "-" ||
         (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode));
}

std::string follow_links(const std::string& path) {
  constexpr int most_links = 40;  // as many as the system follows
  std::string end = path;
  for (int i = 0; i < most_links; ++i) {
    struct stat status {};
    if (::stat(end.c_str(), &status) == 0) return io::real_path(end);
    std::string next = io::link_target(end);  // of a link to what is not there yet
    if (next.empty()) return end;
    end = std::move(next);
  }
  throw Error(ErrorCode::CannotWrite,
              path + ": cannot be written: " + std::strerror(ELOOP) + "; name the file that is meant");
}

void remove_unfinished_files() noexcept {
  for (io::Slot& slot : io::unfinished) {
    if (slot.filled) ::unlink(slot.name.data());
  }
}

void write_text(const std::string& path, const std::string& text) {
  io::SafeFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace rimline
