// SPDX-License-Identifier: GPL-3.0-or-later
// The text of --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace rimline::cli {

// The example, then the description, the usage, and the options by group.
std::string help_of_subcommand(const CLI::App& command);
std::string help_of_tool(const CLI::App& tool);

// "-o, --output MESH", "IN".
std::string label(const CLI::Option& option);

}  // namespace rimline::cli
