// SPDX-License-Identifier: GPL-3.0-or-later
// The output files of a run, checked before any work.
#pragma once

#include <string>
#include <vector>

namespace rimline::cli {

struct Output {
  std::string flag;                             // "--report", for the message
  std::string path;                             // empty: not asked for; "-": standard output
  std::vector<std::string> endings;             // lower case, without the dot; empty where `check` tells
  bool may_be_standard = true;                  // "-" is allowed
  void (*check)(const std::string&) = nullptr;  // throws Error{BadOption} for an ending it does not know
};

// Throws Error{BadOption} for an ending that is not known, two outputs in one place, or "-" where it can not
// be; Error{CannotWrite} for a folder that is missing or may not be written to.
void check_outputs(const std::vector<Output>& outputs);

bool any_standard(const std::vector<Output>& outputs);

// Those that were asked for and are files, with commas between.
std::string list_files(const std::vector<Output>& outputs);

// The ending in lower case without its dot, or "".
std::string ending_of(const std::string& path);

}  // namespace rimline::cli
