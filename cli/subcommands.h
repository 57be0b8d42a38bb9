// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands, one in each file. Each adds itself to the tool and is run by its callback.
#pragma once

#include <CLI/CLI.hpp>

namespace rimline::cli {

void add_boundary(CLI::App& tool);
void add_reconstruct(CLI::App& tool);
void add_parameterize(CLI::App& tool);
void add_info(CLI::App& tool);
void add_sample(CLI::App& tool);

}  // namespace rimline::cli
