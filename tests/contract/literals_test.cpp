// SPDX-License-Identifier: GPL-3.0-or-later
// Every tuned number of the default method stands in src/base/model.h, each with its unit, meaning and
// source.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tool.h"

using namespace rimline::test;

namespace {

namespace fs = std::filesystem;

const fs::path root = RIMLINE_SOURCE;

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream in(read_file(file.string()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Numbers that are part of a formula or of a loop: counts, halves, corners of a triangle, and guards of
// quotients.
const std::set<std::string> structural{"0",   "1",   "2",  "3",  "4",      "0.5",  "0.0",
                                       "1.0", "2.0", "0u", "1u", "1e-300", "1e300"};

// What the comment of a line says of its numbers: they change no result but time, keep rounding out, are
// bits, bytes and constants of nature, or the default of an option.
const std::regex marked(R"(//.*\[(speed|guard|layout|option)\])");

std::vector<std::string> bare_numbers(const std::string& line) {
  if (line.starts_with("#") || std::regex_search(line, marked)) return {};
  static const std::regex text(R"("[^"]*")");
  static const std::regex number(R"((^|[^\w.])((0x[0-9a-fA-F]+|\d[\d']*\.?\d*([eE][-+]?\d+)?)[uUfFlL]*))");
  const std::string code = std::regex_replace(line.substr(0, line.find("//")), text, "");
  std::vector<std::string> found;
  for (std::sregex_iterator i(code.begin(), code.end(), number), end; i != end; ++i) {
    const std::string token = (*i)[2];
    if (!structural.contains(token)) found.push_back(token);
  }
  return found;
}

// One coefficient of the model: its comment and its value.
struct Coefficient {
  std::string comment, name, value;
};

std::vector<Coefficient> coefficients() {
  static const std::regex value(R"(^\s*(inline constexpr )?(int|double|float|std::size_t) (\w+ = [^;]*);)");
  static const std::regex part(R"((\w+) = ([-\w.]+))");
  std::vector<Coefficient> found;
  std::string comment;
  std::vector<std::string> lines = lines_of(root / "src/base/model.h");
  for (const char* more : {"src/base/model_search.h", "src/base/model_clean.h"}) {
    for (const std::string& line : lines_of(root / more)) lines.push_back(line);
  }
  for (const std::string& line : lines) {
    std::smatch match;
    const std::size_t text = line.find("// ");
    if (text != std::string::npos && line.find_first_not_of(' ') == text) {
      const std::string rest = line.substr(text + 3);
      const bool starts = comment.empty() || comment.ends_with("]");
      comment = starts ? rest : comment + " " + rest;
    } else if (std::regex_search(line, match, value)) {
      const std::string all = match[3];
      for (std::sregex_iterator i(all.begin(), all.end(), part), end; i != end; ++i)
        found.push_back({comment, (*i)[1], (*i)[2]});
      comment.clear();
    } else {
      comment.clear();
    }
  }
  return found;
}

}  // namespace

TEST_CASE("bare numbers are told from formulas, names, text and marked lines") {
  CHECK(bare_numbers("  return x > 0.7 * y[2];") == std::vector<std::string>{"0.7"});
  CHECK(bare_numbers("  const double b2 = 1e-9 + 0x1F;") == std::vector<std::string>{"1e-9", "0x1F"});
  CHECK(bare_numbers("  x = 0.5 * (a1 + b);  // 17 of them").empty());
  CHECK(bare_numbers("  block = 64;  // [speed]").empty());
  CHECK(bare_numbers("  say(\"12 points\");").empty());
}

TEST_CASE("the rooms of the default method hold no tuned number") {
  int files = 0;
  for (const std::string room : {"clean", "local", "surface", "evidence", "search", "loops"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / "src" / room)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".h" && ending != ".cpp") continue;
      ++files;
      CAPTURE(entry.path().string());
      for (const std::string& line : lines_of(entry.path())) {
        CAPTURE(line);
        CHECK(bare_numbers(line) == std::vector<std::string>{});
      }
    }
  }
  CHECK(files > 40);
}

TEST_CASE("each coefficient of the model has a unit, a meaning, a source, and a row in docs/model.md") {
  const std::regex form(R"(^[^:]+: .+ \[(fitted \w+|hand|derived)([:;] .+)?\]$)");
  const std::vector<Coefficient> all = coefficients();
  CHECK(all.size() > 100);
  const std::string page = read_file((root / "docs/model.md").string());
  for (const Coefficient& c : all) {
    CAPTURE(c.name);
    CAPTURE(c.comment);
    CHECK(std::regex_match(c.comment, form));
    CHECK(page.find("| `" + c.name + "` | " + c.value + " |") != std::string::npos);
  }
}
