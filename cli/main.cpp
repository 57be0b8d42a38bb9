// SPDX-License-Identifier: GPL-3.0-or-later
// rimline: the command line tool. Exit status: 0 done; 1 bad usage; 2 the input can not be read; 3 the data
// can not give the answer; 4 out of memory or disk; 5 interrupted.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <span>
#include <string>

#include "help.h"
#include "interrupt.h"
#include "rimline/run.h"
#include "rimline/version.h"
#include "standard_streams.h"
#include "subcommands.h"

namespace rimline::cli {
namespace {

constexpr std::size_t most_ids_listed = 10;

int say(const std::string& message, int status) {
  const std::string line = "rimline: " + message + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);  // a closed standard error leaves the exit status alone
  return status;
}

// " (17 points: 3, 5, ...)", or "" where no point is the reason.
std::string offenders(const std::vector<Index>& ids) {
  if (ids.empty()) return "";
  const std::span listed(ids.data(), std::min(ids.size(), most_ids_listed));
  return fmt::format(" ({} {}: {}{})", ids.size(), ids.size() == 1 ? "point" : "points",
                     fmt::join(listed, ", "), listed.size() < ids.size() ? ", ..." : "");
}

std::string where_to_look(const CLI::App& tool) {
  const auto called = tool.get_subcommands();
  return called.empty() ? "; see rimline --help"
                        : fmt::format("; see rimline {} --help", called.front()->get_name());
}

// One sentence for an error of CLI11.
std::string sentence(const CLI::App& tool, const CLI::ParseError& error, int argc, char** argv) {
  if (tool.get_subcommands().empty()) {
    if (argc < 2) return "a subcommand is missing";
    return fmt::format("there is no subcommand '{}'", argv[1]);
  }
  const auto extra = tool.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extra.empty()) {
    if (extra.front().starts_with("-")) return fmt::format("there is no option '{}'", extra.front());
    return fmt::format("'{}' is one argument too many", extra.front());
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    for (const CLI::Option* option : tool.get_subcommands().front()->get_options()) {
      if (option->get_required() && option->count() == 0) return label(*option) + " is missing";
    }
  }
  return error.what();
}

int failed(const CLI::App& tool, const Error& error) {
  if (interrupted) return say("interrupted", exit_status(ErrorCode::Cancelled));
  const std::string hint = error.code() == ErrorCode::BadOption ? where_to_look(tool) : "";
  return say(error.what() + offenders(error.ids()) + hint, exit_status(error.code()));
}

int run_tool(int argc, char** argv) {
  CLI::App tool("Find the boundary of an open surface in a point cloud, map it to the plane, and mesh it.",
                "rimline");
  tool.footer("rimline reconstruct scan.ply -o mesh.ply --report report.json");
  tool.formatter_fn(
      [](const CLI::App* app, const std::string&, CLI::AppFormatMode) { return help_of_tool(*app); });
  tool.set_version_flag("--version", std::string("rimline ") + version);
  tool.require_subcommand(1);
  add_boundary(tool);
  add_reconstruct(tool);
  add_parameterize(tool);
  add_info(tool);
  add_sample(tool);
  try {
    tool.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", tool.help());
  } catch (const CLI::CallForVersion& asked) {
    fmt::print("{}\n", asked.what());
  } catch (const CLI::ParseError& error) {
    return say(sentence(tool, error, argc, argv) + where_to_look(tool), exit_status(ErrorCode::BadOption));
  } catch (const Error& error) {
    return failed(tool, error);
  }
  return 0;
}

// Status 4 where the output did not reach its reader (a full disk, a closed pipe).
int flushed(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  return status != 0 ? status
                     : say("standard output was closed or is full: not all was written",
                           exit_status(ErrorCode::CannotWrite));
}

}  // namespace
}  // namespace rimline::cli

int main(int argc, char** argv) {
  using namespace rimline;
  cli::open_standard_streams();
  cli::catch_interrupts();
  try {
    return cli::flushed(cli::run_tool(argc, argv));
  } catch (const std::bad_alloc&) {
    return cli::say("out of memory", exit_status(ErrorCode::OutOfMemory));
  } catch (const std::system_error& error) {
    // fmt throws these when a stream fails.
    return cli::say(error.what(), exit_status(ErrorCode::CannotWrite));
  } catch (const std::exception& error) {
    return cli::say(std::string("this should not happen, please report it: ") + error.what(), 70);
  }
}
