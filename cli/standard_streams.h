// SPDX-License-Identifier: GPL-3.0-or-later
// Standard input, output and error where the caller has closed them.
#pragma once

#include <string>

namespace rimline::cli {

// Puts something in the place of each stream that is closed, so that no file that is opened later gets its
// number, and with it what is printed. Reading from a closed standard input and writing to a closed standard
// output fail as they would have; messages to a closed standard error are dropped. To be called first.
void open_standard_streams();

// Prints what was done: to standard error where standard output carries an output, else there. Dropped where
// that is closed: all that was asked for is written.
void print_notice(const std::string& text, bool output_is_standard);

}  // namespace rimline::cli
