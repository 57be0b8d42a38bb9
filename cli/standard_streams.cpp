// SPDX-License-Identifier: GPL-3.0-or-later
#include "standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace rimline::cli {
namespace {

bool standard_output = true;

bool is_open(int descriptor) { return fcntl(descriptor, F_GETFD) >= 0; }

// The system gives the lowest number that is free: that of the first closed stream, in order.
void fill(int descriptor, int flags) {
  if (!is_open(descriptor)) (void)open("/dev/null", flags);
}

}  // namespace

void open_standard_streams() {
  standard_output = is_open(STDOUT_FILENO);
  fill(STDIN_FILENO, O_WRONLY);   // can not be read
  fill(STDOUT_FILENO, O_RDONLY);  // can not be written
  fill(STDERR_FILENO, O_WRONLY);
}

void print_notice(const std::string& text, bool output_is_standard) {
  if (!output_is_standard && !standard_output) return;
  std::fwrite(text.data(), 1, text.size(), output_is_standard ? stderr : stdout);
}

}  // namespace rimline::cli
