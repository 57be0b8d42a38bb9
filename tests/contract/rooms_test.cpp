// SPDX-License-Identifier: GPL-3.0-or-later
// docs/architecture.md says which room may include which; the code does no other.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "tool.h"

using namespace rimline::test;

namespace {

namespace fs = std::filesystem;

const fs::path root = RIMLINE_SOURCE;

using Rooms = std::map<std::string, std::set<std::string>>;

// All `names` of a cell.
std::set<std::string> names_in(const std::string& cell) {
  std::set<std::string> names;
  for (std::size_t at = 0; (at = cell.find('`', at)) != std::string::npos;) {
    const std::size_t end = cell.find('`', at + 1);
    names.insert(cell.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return names;
}

// The rows of the table under "| room |": the room, and those that it may include.
Rooms read_rooms() {
  Rooms rooms;
  std::istringstream lines(read_file((root / "docs/architecture.md").string()));
  bool in_table = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("| room |")) in_table = true;
    if (!line.starts_with("|")) in_table = false;
    if (!in_table || !line.starts_with("| `")) continue;
    const std::size_t last = line.rfind('|', line.size() - 2);
    const std::string room = line.substr(3, line.find('`', 3) - 3);
    rooms[room] = names_in(line.substr(last));
  }
  return rooms;
}

std::vector<fs::path> code_below(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".h" || ending == ".cpp") files.push_back(fs::relative(entry.path(), root));
  }
  std::sort(files.begin(), files.end());
  return files;
}

// What a file includes of ours, as written: "map/weights.h".
std::vector<std::string> includes_of(const fs::path& file) {
  constexpr std::string_view start = "#include \"";
  std::vector<std::string> includes;
  std::istringstream lines(read_file((root / file).string()));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(start)) continue;
    includes.push_back(line.substr(start.size(), line.find('"', start.size()) - start.size()));
  }
  return includes;
}

std::string room_of(const std::string& include) { return include.substr(0, include.find('/')); }

// The rooms that can be reached from one by permitted includes.
std::set<std::string> reach(const Rooms& rooms, const std::string& from) {
  std::set<std::string> seen;
  std::vector<std::string> open = {from};
  while (!open.empty()) {
    const std::string room = open.back();
    open.pop_back();
    for (const std::string& next : rooms.at(room)) {
      if (seen.insert(next).second) open.push_back(next);
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("the rooms of docs/architecture.md are the folders of src, and nothing lies loose at its door") {
  const Rooms rooms = read_rooms();
  CHECK(rooms.size() > 15);
  for (const auto& entry : fs::directory_iterator(root / "src")) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    if (entry.is_directory()) {
      CHECK(rooms.contains(name));
    } else {
      CHECK(name == "CMakeLists.txt");
    }
  }
  for (const auto& [room, may] : rooms) {
    CAPTURE(room);
    CHECK(fs::is_directory(root / "src" / room));
    for (const std::string& other : may) CHECK(rooms.contains(other));
  }
}

TEST_CASE("no room includes another that docs/architecture.md does not permit") {
  const Rooms rooms = read_rooms();
  int looked_at = 0;
  for (const fs::path& file : code_below("src")) {
    const std::string own = std::next(file.begin())->string();
    if (!rooms.contains(own)) continue;  // the test above says so
    for (const std::string& include : includes_of(file)) {
      const std::string other = room_of(include);
      if (other == "rimline" || other == own) continue;
      CAPTURE(file.string());
      CAPTURE(include);
      CHECK(rooms.at(own).contains(other));
      ++looked_at;
    }
  }
  CHECK(looked_at > 100);
}

TEST_CASE("the permitted includes form no cycle") {
  const Rooms rooms = read_rooms();
  for (const auto& [room, may] : rooms) {
    CAPTURE(room);
    CHECK_FALSE(reach(rooms, room).contains(room));
  }
}

TEST_CASE("public headers include public headers alone, and the tool sees nothing else of the library") {
  for (const fs::path& file : code_below("include")) {
    CAPTURE(file.string());
    for (const std::string& include : includes_of(file)) CHECK(include.starts_with("rimline/"));
  }
  for (const fs::path& file : code_below("cli")) {
    CAPTURE(file.string());
    for (const std::string& include : includes_of(file)) {
      CAPTURE(include);
      CHECK((include.starts_with("rimline/") || include.find('/') == std::string::npos));
    }
  }
}

TEST_CASE("no file has more than 400 lines or more than 12 includes of ours") {
  for (const std::string folder : {"src", "include", "cli"}) {
    for (const fs::path& file : code_below(folder)) {
      CAPTURE(file.string());
      const std::string text = read_file((root / file).string());
      CHECK(std::count(text.begin(), text.end(), '\n') <= 400);
      CHECK(includes_of(file).size() <= 12);
    }
  }
}

TEST_CASE("single domains and presets are asked for in their traits alone") {
  const auto asks = [](const std::string& text) {
    for (const std::string question : {"== ", "!= ", "case "}) {
      for (const std::string kind : {"Domain::", "Preset::"}) {
        if (text.find(question + kind) != std::string::npos) return true;
      }
    }
    return false;
  };
  int traits = 0;
  for (const std::string folder : {"src", "cli"}) {
    for (const fs::path& file : code_below(folder)) {
      const bool found = asks(read_file((root / file).string()));
      const std::string name = file.filename().string();
      CAPTURE(file.string());
      CHECK(found == (name == "domain_traits.h" || name == "preset_traits.h"));
      traits += found;
    }
  }
  CHECK(traits == 2);
}

TEST_CASE("nothing of ours includes a header under its former name") {
  std::set<std::string> former;
  for (const fs::path& file : code_below("include/deprecated"))
    former.insert("rimline/" + file.filename().string());
  CHECK_FALSE(former.empty());
  for (const std::string folder : {"src", "include/rimline", "cli", "tests", "bench", "examples"}) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::path& file : code_below(folder)) {
      CAPTURE(file.string());
      for (const std::string& include : includes_of(file)) {
        CAPTURE(include);
        CHECK_FALSE(former.contains(include));
      }
    }
  }
}
