// SPDX-License-Identifier: GPL-3.0-or-later
// Real scans for tests: the folders that the environment variable RIMLINE_DATA lists, parted by `:`.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace rimline {

inline std::vector<std::string> data_folders() {
  const char* list = std::getenv("RIMLINE_DATA");
  std::istringstream names(list == nullptr ? "" : list);
  std::vector<std::string> folders;
  for (std::string folder; std::getline(names, folder, ':');) {
    if (std::filesystem::is_directory(folder)) folders.push_back(folder);
  }
  return folders;
}

// The path of a file in the first folder that has it; "", and said aloud, where none has.
inline std::string data_file(const std::string& name) {
  for (const std::string& folder : data_folders()) {
    const std::string path = folder + "/" + name;
    if (std::filesystem::exists(path)) return path;
  }
  MESSAGE("skipped: RIMLINE_DATA has no file ", name);
  return "";
}

// The files below any of the folders whose names start so, in order; said aloud where there are none.
inline std::vector<std::string> data_files(const std::string& start) {
  std::vector<std::string> files;
  for (const std::string& folder : data_folders()) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().filename().string().starts_with(start)) files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) MESSAGE("skipped: RIMLINE_DATA has no file ", start, "*");
  return files;
}

}  // namespace rimline
