// SPDX-License-Identifier: GPL-3.0-or-later
// The table of formats is told the same everywhere: docs/formats.md, README.md and --help.
#include "rimline/formats.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "tool.h"

using namespace rimline;
using namespace rimline::test;

namespace {

std::string page(const std::string& name) { return read_file(std::string(RIMLINE_SOURCE) + "/" + name); }

void check_has(const std::string& text, const std::string& part) {
  CHECK_MESSAGE(text.find(part) != std::string::npos, "missing: " << part);
}

// Without line ends, so that where a paragraph is broken does not matter.
std::string in_one_line(std::string text) {
  std::string result;
  for (const char c : text) {
    if (c != '\n' && c != ' ') result += c;
    if ((c == '\n' || c == ' ') && !result.empty() && result.back() != ' ') result += ' ';
  }
  return result;
}

}  // namespace

TEST_CASE("docs/formats.md has the rows of the table of formats") {
  const std::string docs = page("docs/formats.md");
  for (const FileFormat& format : file_formats()) {
    if (format.reading) {
      check_has(docs, fmt::format("\n| {} (`.{}`) | {} | {} | {} |\n", format.name,
                                  fmt::join(format.endings, "`, `."), format.reading->told_by,
                                  format.reading->points, format.reading->kept));
    }
    if (format.mesh) {
      check_has(docs, fmt::format("\n| `.{}` | {} | {} |\n", format.mesh->ending, format.mesh->vertices,
                                  format.mesh->beside));
    }
    if (format.loops)
      check_has(docs, fmt::format("\n| `.{}` | {} |\n", format.loops->ending, format.loops->content));
  }
}

TEST_CASE("README.md names all formats that are read") {
  const std::string readme = page("README.md");
  for (const FileFormat& format : file_formats()) {
    if (format.reading) check_has(readme, std::string(format.name));
  }
}

TEST_CASE("help tells the formats of the table") {
  const std::string help = in_one_line(rimline::test::rimline({"reconstruct", "--help"}).out);
  check_has(help, names_of_formats(FormatUse::ReadPoints));
  check_has(help, names_of_formats(FormatUse::ReadFaces));
  check_has(help, text_of_endings(FormatUse::WriteLoops));
  check_has(help, fmt::format("MESH.{{{}}}", fmt::join(written_endings(FormatUse::WriteMesh), ",")));
}

TEST_CASE("no two formats read or write the same ending") {
  std::set<std::string_view> read, mesh, loops;
  for (const FileFormat& format : file_formats()) {
    if (format.reading) {
      for (const std::string_view ending : format.endings) CHECK(read.insert(ending).second);
    }
    if (format.mesh) CHECK(mesh.insert(format.mesh->ending).second);
    if (format.loops) CHECK(loops.insert(format.loops->ending).second);
  }
  CHECK(read.size() >= 6);
  CHECK(mesh.size() >= 5);
}
