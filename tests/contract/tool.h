// SPDX-License-Identifier: GPL-3.0-or-later
// The built tool as a user meets it: a process, its streams, its files and its status.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rimline::test {

struct Call {
  std::vector<std::string> arguments;
  std::string input = {};        // given on standard input, which then ends
  bool keep_input_open = false;  // it does not end: the tool waits for more
  bool terminal = false;         // standard error is a terminal
  std::string output_to = {};    // standard output goes to this file instead of `Finished::out`
  std::size_t memory = 0;        // bytes of address space, 0 for no limit
  std::size_t file_size = 0;     // most bytes of any file, 0 for no limit
  bool no_threads = false;       // run as a user who may make no thread; root becomes `nobody` for it
  bool closed_streams = false;   // descriptors 0 to 2 are closed
  bool hold_output = false;      // standard output is read after the signal only
  int signal = 0;                // sent as soon as `signal_when` says so
  int signals = 1;               // how often
  bool deadline = true;          // false: the timer that ends an interrupted tool never fires
  std::function<bool(const std::string& err, bool input_taken)> signal_when = {};
};

struct Finished {
  int status = -1;  // the exit status; 128 + the signal's number where one ended the tool
  std::string out, err;
};

Finished run(const Call& call);
// run() of the arguments alone.
Finished rimline(std::vector<std::string> arguments);

// An empty folder that goes away with its owner.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  // What it holds, in order.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& bytes);

}  // namespace rimline::test
