// SPDX-License-Identifier: GPL-3.0-or-later
#include "help.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace rimline::cli {
namespace {

constexpr std::size_t line_width = 100;
constexpr std::size_t text_column = 30;

const char* const exit_statuses =
    "Exit status: 0 done; 1 bad usage; 2 the input can not be read; 3 the data can not give the answer;\n"
    "4 out of memory or disk; 5 interrupted.\n";

// `text` broken into lines that begin at `column`.
std::string wrapped(const std::string& text, std::size_t column) {
  std::string result;
  std::size_t used = column;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::size_t length = end - begin;
    if (used > column && used + 1 + length > line_width) {
      result += '\n' + std::string(column, ' ');
      used = column;
    } else if (used > column) {
      result += ' ';
      ++used;
    }
    result += text.substr(begin, length);
    used += length;
    begin = end + 1;
  }
  return result;
}

std::string row(const std::string& left, const std::string& right) {
  std::string text = "  " + left;
  if (text.size() + 2 > text_column) {
    text += '\n' + std::string(text_column, ' ');
  } else {
    text.resize(text_column, ' ');
  }
  return text + wrapped(right, text_column) + '\n';
}

// The groups in the order of their first option, "Run" last.
std::vector<std::string> groups_of(const CLI::App& command) {
  std::vector<std::string> groups;
  for (const CLI::Option* option : command.get_options()) {
    const std::string& group = option->get_group();
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  std::stable_partition(groups.begin(), groups.end(), [](const auto& group) { return group == "Files"; });
  std::stable_partition(groups.begin(), groups.end(), [](const auto& group) { return group != "Run"; });
  return groups;
}

std::string usage(const CLI::App& command) {
  std::string text = "Usage: rimline " + command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required()) continue;
    const bool shortened = !option->get_positional() && !option->get_snames().empty();
    text += shortened ? " -" + option->get_snames().front() + " " + option->get_type_name()
                      : " " + label(*option);
  }
  return text + " [options]\n";
}

}  // namespace

std::string label(const CLI::Option& option) {
  if (option.get_positional()) return option.get_type_name();
  std::string text;
  for (const auto& shortened : option.get_snames()) text += "-" + shortened + ", ";
  for (const auto& full : option.get_lnames()) text += "--" + full + ", ";
  text.resize(text.size() - 2);
  if (option.get_items_expected_max() > 0) text += " " + option.get_type_name();
  return text;
}

std::string help_of_subcommand(const CLI::App& command) {
  std::string text = "Example: " + command.get_footer() + "\n\n";
  text += wrapped(command.get_description(), 0) + "\n\n" + usage(command);
  for (const std::string& group : groups_of(command)) {
    text += '\n' + group + '\n';
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_group() == group) text += row(label(*option), option->get_description());
    }
  }
  return text + '\n' + exit_statuses;
}

std::string help_of_tool(const CLI::App& tool) {
  std::string text = "Example: " + tool.get_footer() + "\n\n";
  text += wrapped(tool.get_description(), 0) + "\n\nUsage: rimline SUBCOMMAND [options]\n\nSubcommands\n";
  for (const CLI::App* command : tool.get_subcommands({})) {
    text += row(command->get_name(), command->get_description());
  }
  text += "\nRun\n" + row("-h, --help", "Print this and end; rimline SUBCOMMAND --help tells more") +
          row("--version", "Print the version and end");
  return text + '\n' + exit_statuses;
}

}  // namespace rimline::cli
