// SPDX-License-Identifier: GPL-3.0-or-later
// docs/method.md leads from the paper to the code and its tests: every file, name and test in it is there.
#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <sstream>

#include "tool.h"

using namespace rimline::test;

namespace {

namespace fs = std::filesystem;

const fs::path root = RIMLINE_SOURCE;

// The text of all files below a folder.
std::string text_below(const std::string& folder) {
  std::string text;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".h" || ending == ".cpp") text += read_file(entry.path().string());
  }
  return text;
}

// What stands between two marks of a kind, as `this`.
std::vector<std::string> between(const std::string& line, char mark) {
  std::vector<std::string> parts;
  std::size_t at = 0;
  while ((at = line.find(mark, at)) != std::string::npos) {
    const std::size_t end = line.find(mark, at + 1);
    if (end == std::string::npos) break;
    parts.push_back(line.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return parts;
}

// Paths such as src/patch/refine.cpp.
std::vector<std::string> paths_in(const std::string& line) {
  std::vector<std::string> paths;
  for (const std::string folder : {"src/", "tests/", "include/"}) {
    for (std::size_t at = 0; (at = line.find(folder, at)) != std::string::npos; ++at) {
      if (at > 0 && line[at - 1] == '/') continue;
      std::size_t end = at;
      while (end < line.size() && (std::isalnum(static_cast<unsigned char>(line[end])) != 0 ||
                                   line[end] == '/' || line[end] == '_' || line[end] == '.')) {
        ++end;
      }
      while (line[end - 1] == '.') --end;
      paths.push_back(line.substr(at, end - at));
    }
  }
  return paths;
}

// Without comments and with single blanks.
std::string plain(const std::string& code) {
  std::string text;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) text += line.substr(0, line.find("//")) + " ";
  std::istringstream words(text);
  text.clear();
  for (std::string word; words >> word;) text += word + " ";
  return text;
}

// The statements of the first block of C++ under a heading.
std::vector<std::string> statements_under(const std::string& page, const std::string& heading) {
  constexpr std::string_view fence = "```cpp\n";
  const std::size_t start = page.find(fence, page.find(heading)) + fence.size();
  const std::string block = page.substr(start, page.find("```", start) - start);
  std::vector<std::string> statements;
  std::istringstream lines(block);
  for (std::string line; std::getline(lines, line);) statements.push_back(plain(line));
  return statements;
}

bool is_name(const std::string& text) {
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != ':') return false;
  }
  return !text.empty();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A test that a row names: `tests/a_test.cpp: "one", "two"; tests/b_test.cpp: "three"`.
struct NamedTest {
  std::string file, name;  // file: the last one before the name; empty where there is none
};

std::vector<NamedTest> tests_in(const std::string& line) {
  std::vector<NamedTest> tests;
  std::string before;
  std::size_t at = 0;
  for (const std::string& name : between(line, '"')) {
    const std::size_t quote = line.find('"' + name + '"', at);
    before += line.substr(at, quote - at);
    at = quote + name.size() + 2;
    std::string file;
    for (const std::string& path : paths_in(before)) file = path.starts_with("tests/") ? path : file;
    tests.push_back({file, name});
  }
  return tests;
}

// Whether the file has a test of that name; one that ends in dots may go on.
bool has_test(const NamedTest& test) {
  if (!fs::is_regular_file(root / test.file)) return false;
  std::string wanted = "TEST_CASE(\"" + test.name + "\"";
  if (test.name.ends_with("...")) wanted = wanted.substr(0, wanted.find_last_not_of(" .\"") + 1);
  return contains(read_file((root / test.file).string()), wanted);
}

}  // namespace

TEST_CASE("every file, name and test that docs/method.md gives is there") {
  const std::string code = text_below("src") + text_below("include");
  std::istringstream lines(read_file((root / "docs/method.md").string()));
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("|")) continue;
    ++rows;
    CAPTURE(line);
    for (const std::string& path : paths_in(line)) CHECK(fs::exists(root / path));
    for (std::string name : between(line, '`')) {
      if (!is_name(name)) continue;
      if (contains(name, "::")) name = name.substr(name.rfind(':') + 1);
      CHECK(contains(code, name));
    }
    for (const NamedTest& test : tests_in(line)) {
      CAPTURE(test.file);
      CAPTURE(test.name);
      CHECK(has_test(test));
    }
  }
  CHECK(rows > 40);
}

TEST_CASE("the check of docs/method.md sees a test that is not there, and one that is in another file") {
  const std::string here = "tests/contract/docs_test.cpp", elsewhere = "tests/contract/usage_test.cpp";
  const std::string name = "the check of docs/method.md sees ...";
  const auto found = tests_in("| x | " + elsewhere + "; " + here + ": \"" + name + "\" |");
  REQUIRE(found.size() == 1);
  CHECK(found[0].file == here);
  CHECK(has_test(found[0]));
  CHECK_FALSE(has_test({elsewhere, name}));
  CHECK_FALSE(has_test({here, "the check of docs/method.md sees"}));  // a name is whole, or ends in dots
  CHECK_FALSE(has_test({"tests/contract/no_test.cpp", name}));
  CHECK_FALSE(has_test({"", name}));
}

TEST_CASE("every definition, assumption, theorem, algorithm and equation of the paper has its row") {
  const std::string method = read_file((root / "docs/method.md").string());
  for (const char* item :
       {"Definition 2.1", "Definition 2.2",    "Assumption 2.3", "Assumption 2.4", "Assumption 2.5",
        "Assumption 2.6", "Theorems 2.7, 2.8", "Algorithm 3.1",  "Algorithm 3.2",  "eq. (1)",
        "eq. (2)",        "eq. (3)",           "eq. (4)",        "section 2.2",    "section 2.3",
        "section 2.5",    "section 3.1",       "section 3.2",    "section 4",      "section 5",
        "section 6"}) {
    CAPTURE(item);
    CHECK(contains(method, "| " + std::string(item) + " |"));
  }
}

TEST_CASE("the flow that docs/architecture.md prints is that of reconstruct") {
  const std::string pipeline = plain(read_file((root / "src/pipeline/pipeline.cpp").string()));
  const std::string reconstruct = pipeline.substr(pipeline.find("ReconstructResult reconstruct("));
  const auto statements =
      statements_under(read_file((root / "docs/architecture.md").string()), "## What flows");
  CHECK(statements.size() >= 6);
  for (const std::string& statement : statements) {
    CAPTURE(statement);
    CHECK(contains(reconstruct, statement));
  }
}
