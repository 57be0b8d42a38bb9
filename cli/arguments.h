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

// Options of every subcommand.
struct Common {
  std::uint64_t seed = 1;
  int threads = 0;
  std::size_t memory_limit = 0;  // bytes; 0 for none
  bool quiet = false;
};

// The input file, and the points taken from it.
struct Input {
  std::string path;
  PointFilter filter;
};

// Options of the subcommands that run the method. An empty path means that the file was not asked for.
struct MethodArguments {
  Common common;
  Preset preset = Preset::Default;
  Input input;
  std::string output, loops, report, picture, history;
  std::string use_loops;
  std::optional<Point> up;
  std::optional<Point> viewpoint;
  std::optional<HolePolicy> holes;
  std::optional<std::array<Index, 4>> corners;
  std::string reference, uv_picture;          // of reconstruct alone
  bool distortion = false;                    // likewise
  int texture_size = 0;                       // likewise; pixels each way, 0 for none
  std::string texture_property;               // likewise
  std::vector<std::string> panels;            // of the picture; none for all
  int picture_size = 620;                     // pixels of each panel
  std::map<std::string, std::string> fields;  // options given as flags: the field's name, its text

  // The preset's options, overridden by the given flags. Throws BadOption for a flag that has no effect under
  // them.
  Options options() const;
  // The given flags that affect a map or a mesh only.
  std::vector<std::string> flags_of_mesh() const;
};

// Adds a subcommand with its help, which begins with `example`. `--help` and `--version` are added, too.
CLI::App& add_subcommand(CLI::App& tool, const std::string& name, const std::string& description,
                         const std::string& example);

// An option that takes the path of a file, or "-". An empty path (an unset variable of a script) is bad
// usage.
CLI::Option* add_path(CLI::App& command, const std::string& flags, std::string& path,
                      const std::string& value, const std::string& description);

void add_common(CLI::App& command, Common& common);
// IN, and the filter of its points: --class, --returns.
void add_input(CLI::App& command, Input& input);
void add_output(CLI::App& command, std::string& output, const std::string& value,
                const std::string& description, bool required);

// --preset, --loops, --use-loops, --report, --history, --picture, --up, --viewpoint and one flag per field of
// the options.
void add_method(CLI::App& command, MethodArguments& arguments);

// --reference, --distortion, --uv-picture and other options of a mesh.
void add_mesh_method(CLI::App& command, MethodArguments& arguments);

// An option whose text `parse` converts; an error that it throws ends the tool with status 1.
CLI::Option* add_parsed(CLI::App& command, const std::string& flags, const std::string& value,
                        const std::string& description, const std::string& group,
                        std::function<void(const std::string&)> parse);

}  // namespace rimline::cli
