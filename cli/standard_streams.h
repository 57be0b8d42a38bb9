// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces standard streams that the caller has closed.
#pragma once

#include <string>

namespace rimline::cli {

// Opens a placeholder for each closed stream, so that no file opened later gets its number, and with it the
// printed text. Reading from a closed standard input and writing to a closed standard output still fail;
// messages to a closed standard error are dropped. Must be called first.
void open_standard_streams();

// Prints what was done: to standard error where standard output carries an output, else there. Dropped where
// that is closed: all that was asked for is written.
void print_notice(const std::string& text, bool output_is_standard);

}  // namespace rimline::cli
