// SPDX-License-Identifier: GPL-3.0-or-later
// What --help prints.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace rimline::cli {

// The example on top, then what it does, how it is called, and the options by group.
std::string help_of_subcommand(const CLI::App& command);
std::string help_of_tool(const CLI::App& tool);

// "-o, --output MESH", "IN".
std::string label(const CLI::Option& option);

}  // namespace rimline::cli
