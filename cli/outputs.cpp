// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "rimline/io.h"
#include "rimline/run.h"

namespace rimline::cli {
namespace {

namespace fs = std::filesystem;

void check_ending(const Output& output) {
  if (output.path == "-") {
    if (output.may_be_standard) return;
    throw Error(ErrorCode::BadOption, output.flag + " can not go to standard output; give it a file name");
  }
  if (output.may_be_standard && ending_of(output.path).empty() && is_stream(output.path)) return;
  if (output.check != nullptr) {
    try {
      return output.check(output.path);
    } catch (const Error& error) {
      throw Error(error.code(), output.flag + " " + error.what());
    }
  }
  const auto& known = output.endings;
  if (std::find(known.begin(), known.end(), ending_of(output.path)) != known.end()) return;
  throw Error(ErrorCode::BadOption, fmt::format("{} wants a file name that ends in .{}, not '{}'",
                                                output.flag, fmt::join(known, " or ."), output.path));
}

void check_place(const Output& output) {
  const fs::path path = follow_links(output.path);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  const auto refuse = [&output](const std::string& why) {
    throw Error(ErrorCode::CannotWrite, fmt::format("{} {}: {}", output.flag, output.path, why));
  };
  if (is_stream(output.path)) {  // no file is made beside it
    if (access(path.c_str(), W_OK) != 0) refuse("it may not be written to");
    return;
  }
  if (!fs::is_directory(folder, ignored)) refuse("there is no folder " + folder.string());
  if (fs::is_directory(path, ignored)) refuse("it is a folder");
  if (access(folder.c_str(), W_OK) != 0) refuse("the folder " + folder.string() + " may not be written to");
  if (fs::exists(path, ignored) && access(path.c_str(), W_OK) != 0) refuse("it may not be written to");
}

}  // namespace

void check_outputs(const std::vector<Output>& outputs) {
  std::set<std::string> places;
  for (const Output& output : outputs) {
    if (output.path.empty()) continue;
    check_ending(output);
    if (output.path != "-") check_place(output);
    if (output.path != "-" && is_stream(output.path)) continue;  // /dev/null takes any number
    std::error_code ignored;
    const std::string end = output.path == "-" ? "-" : follow_links(output.path);
    const fs::path whole = fs::weakly_canonical(fs::absolute(end, ignored), ignored);
    if (!places.insert(output.path == "-" ? "-" : whole.string()).second) {
      throw Error(ErrorCode::BadOption,
                  fmt::format("{} goes to '{}', and so does another output", output.flag, output.path));
    }
  }
}

bool any_standard(const std::vector<Output>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(), [](const Output& output) { return output.path == "-"; });
}

std::string list_files(const std::vector<Output>& outputs) {
  std::string text;
  for (const Output& output : outputs) {
    if (output.path.empty() || output.path == "-") continue;
    text += (text.empty() ? "" : ", ") + output.path;
  }
  return text;
}

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

}  // namespace rimline::cli
