// SPDX-License-Identifier: GPL-3.0-or-later
#include "tool.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace rimline::test {
namespace {

constexpr unsigned nobody = 65534;

struct Pipe {
  int read_end = -1, write_end = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe");
  return {ends[0], ends[1]};
}

Pipe make_terminal() {
  Pipe ends;
  if (openpty(&ends.read_end, &ends.write_end, nullptr, nullptr, nullptr) != 0)
    throw std::runtime_error("pty");
  fcntl(ends.read_end, F_SETFD, FD_CLOEXEC);
  fcntl(ends.write_end, F_SETFD, FD_CLOEXEC);
  return ends;
}

void limit(int resource, std::size_t most) {
  if (most == 0) return;
  const rlimit bound = {most, most};
  setrlimit(static_cast<__rlimit_resource>(resource), &bound);
}

[[noreturn]] void become_tool(const Call& call, int in, int out, int err) {
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  if (!call.deadline) {  // the mask outlives exec
    sigset_t mask;
    sigemptyset(&mask);
    sigaddset(&mask, SIGALRM);
    sigprocmask(SIG_BLOCK, &mask, nullptr);
  }
  limit(RLIMIT_AS, call.memory);
  limit(RLIMIT_FSIZE, call.file_size);
  if (call.no_threads) {
    if (getuid() == 0 && (setgid(nobody) != 0 || setuid(nobody) != 0)) _exit(126);
    limit(RLIMIT_NPROC, 1);
  }
  std::vector<char*> argv = {const_cast<char*>("rimline")};
  for (const std::string& argument : call.arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  if (call.closed_streams) {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) close(stream);
  }
  execv(RIMLINE_TOOL, argv.data());
  _exit(127);
}

// Reads what is there. False once the other side has gone.
bool take(int file, std::string& text) {
  std::array<char, 65536> buffer{};
  const ssize_t count = read(file, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

// One process, from the parent's side.
struct Child {
  const Call& call;
  pid_t id = -1;
  int in = -1, out = -1, err = -1;
  std::size_t given = 0;
  bool signalled = false;

  bool input_taken() const {
    int waiting = 0;
    return given == call.input.size() && in >= 0 && ioctl(in, FIONREAD, &waiting) == 0 && waiting == 0;
  }

  void feed() {
    if (in < 0) return;
    if (given < call.input.size()) {
      const ssize_t count = write(in, call.input.data() + given, call.input.size() - given);
      if (count > 0) given += static_cast<std::size_t>(count);
      if (count < 0 && errno == EPIPE) given = call.input.size();
    }
    if (given == call.input.size() && !call.keep_input_open) {
      close(in);
      in = -1;
    }
  }

  void signal_if_due(const Finished& so_far) {
    if (signalled || call.signal == 0 || !call.signal_when(so_far.err, input_taken())) return;
    for (int i = 0; i < call.signals; ++i) kill(id, call.signal);
    signalled = true;
  }

  void talk(Finished& result) {
    bool out_open = out >= 0, err_open = true;
    while (out_open || err_open) {
      const bool reads_out = out_open && (signalled || !call.hold_output);
      std::array<pollfd, 3> files = {pollfd{reads_out ? out : -1, POLLIN, 0},
                                     pollfd{err_open ? err : -1, POLLIN, 0},
                                     pollfd{in >= 0 && given < call.input.size() ? in : -1, POLLOUT, 0}};
      poll(files.data(), files.size(), 5);
      if (files[0].revents != 0) out_open = take(out, result.out);
      if (files[1].revents != 0) err_open = take(err, result.err);
      feed();
      signal_if_due(result);
    }
  }
};

int status_of(pid_t id) {
  int status = 0;
  while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Finished run(const Call& call) {
  signal(SIGPIPE, SIG_IGN);
  const Pipe in = make_pipe();
  const Pipe err = call.terminal ? make_terminal() : make_pipe();
  Pipe out;
  if (call.output_to.empty()) {
    out = make_pipe();
  } else {
    out.write_end = open(call.output_to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  }
  Child child{.call = call};
  child.id = fork();
  if (child.id == 0) {
    // What the parent ignores the tool would inherit as ignored.
    for (const int number : {SIGPIPE, SIGHUP}) signal(number, SIG_DFL);
    become_tool(call, in.read_end, out.write_end, err.write_end);
  }
  close(in.read_end);
  close(out.write_end);
  close(err.write_end);
  child.in = in.write_end, child.out = out.read_end, child.err = err.read_end;
  fcntl(child.in, F_SETFL, O_NONBLOCK);
  Finished result;
  child.talk(result);
  for (const int file : {child.in, child.out, child.err}) {
    if (file >= 0) close(file);
  }
  result.status = status_of(child.id);
  return result;
}

Finished rimline(std::vector<std::string> arguments) { return run({.arguments = std::move(arguments)}); }

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "rimline-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("no file " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
}

}  // namespace rimline::test
