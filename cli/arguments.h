// SPDX-License-Identifier: GPL-3.0-or-later
// The arguments that subcommands share, each declared in one place.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "outputs.h"
#include "rimline/io.h"
#include "rimline/options.h"
#include "rimline/pipeline.h"
#include "rimline/run.h"

namespace rimline::cli {

// What every subcommand takes.
struct Common {
  std::uint64_t seed = 1;
  int threads = 0;
  std::size_t memory_limit = 0;  // bytes; 0 for none
  bool quiet = false;
};

// Points and which of them.
struct Input {
  std::string path;
  PointFilter filter;
};

// What the subcommands that run the method take. Empty paths are files that were not asked for.
struct MethodArguments {
  Common common;
  Preset preset = Preset::Default;
  Input input;
  std::string output, loops, report, picture, history;
  std::string use_loops;
  std::optional<Point> up;
  std::optional<HolePolicy> holes;
  std::optional<std::array<Index, 4>> corners;
  std::string reference, uv_picture;          // of reconstruct alone
  bool distortion = false;                    // likewise
  int texture_size = 0;                       // likewise; pixels each way, 0 for none
  std::string texture_property;               // likewise
  std::vector<std::string> panels;            // of the picture; none for all
  int picture_size = 620;                     // pixels of each panel
  std::map<std::string, std::string> fields;  // options given as flags: the field's name, its text

  // The preset's options, with what was given as flags on top. Throws BadOption for a flag that does not
  // count under them.
  Options options() const;
  // Flags that were given and count only where a map or a mesh is made.
  std::vector<std::string> flags_of_mesh() const;
};

// Adds a subcommand with its help: `example` stands on top of it. `--help` and `--version` come with it.
CLI::App& add_subcommand(CLI::App& tool, const std::string& name, const std::string& description,
                         const std::string& example);

// An option that takes the path of a file, or "-". An empty one, which a script's unset variable leaves, is
// bad usage.
CLI::Option* add_path(CLI::App& command, const std::string& flags, std::string& path,
                      const std::string& value, const std::string& description);

void add_common(CLI::App& command, Common& common);
// IN, and which of its points are taken: --class, --returns.
void add_input(CLI::App& command, Input& input);
void add_output(CLI::App& command, std::string& output, const std::string& value,
                const std::string& description, bool required);

// --preset, --loops, --use-loops, --report, --history, --picture, --up and one flag per field of the options.
void add_method(CLI::App& command, MethodArguments& arguments);

// --reference, --distortion, --uv-picture: what only a mesh can give.
void add_mesh_method(CLI::App& command, MethodArguments& arguments);

// An option that `parse` turns into a value; what it throws ends the tool with status 1.
CLI::Option* add_parsed(CLI::App& command, const std::string& flags, const std::string& value,
                        const std::string& description, const std::string& group,
                        std::function<void(const std::string&)> parse);

}  // namespace rimline::cli
