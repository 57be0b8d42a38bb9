// SPDX-License-Identifier: GPL-3.0-or-later
// Geomview OFF in text: OFF, COFF, NOFF, STOFF, 4OFF and their mixtures.
#include <fmt/format.h>

#include <string>

#include "io/fields.h"
#include "io/lines.h"
#include "io/readers.h"
#include "io/table.h"

namespace rimline::io {
namespace {

// The letters before OFF, in the order in which the format allows them.
struct OffKind {
  bool texture = false, colour = false, normals = false, weight = false;
};

class OffReader {
 public:
  OffReader(const Source& source, const Run& run) : source_(source), run_(run), lines_(source.bytes()) {}

  Cloud read() {
    const std::uint64_t count = read_header();
    check_point_count(source_, count);
    constexpr std::size_t least_bytes = 5;  // "0 0 0", with a line end between two
    if (count > (source_.bytes_from(lines_.at()) + 1) / (least_bytes + 1)) fail_truncated(count);
    std::string_view line;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (i % items_per_look == 0) source_.progress(run_, lines_.at());
      if (!next(line)) fail_truncated(count);
      read_vertex(line, count);
    }
    if (table_.names.empty()) source_.fail("has no points");
    return cloud_from_table(table_, source_, run_);
  }

 private:
  bool next(std::string_view& line) { return lines_.next_filled(line, '#'); }

  [[noreturn]] void fail_truncated(std::uint64_t count) const {
    source_.fail("ends before the " + std::to_string(count) +
                 " vertices that its header announces; the file is truncated or its count wrong");
  }

  // The keyword may be missing, and the counts may stand on its line. Returns the number of vertices.
  std::uint64_t read_header() {
    std::string_view line;
    if (!next(line)) source_.fail("has no points: nothing but comments");
    Row row(line);
    const std::string_view keyword = Row(row).word();
    if (keyword.ends_with("OFF")) {
      row.word();
      read_kind(keyword.substr(0, keyword.size() - 3), line);
      if (Row(row).word() == "BINARY") {
        source_.fail("is a binary OFF, which is not supported; save it as text or as PLY");
      }
      if (row.done() || *row.at() == '#') {
        if (!next(line)) source_.fail("ends after 'OFF'; the file is truncated");
        row = Row(line);
      }
    }
    std::uint64_t count = 0;
    if (!row.read(count)) {
      source_.fail_at_line(line.data(),
                           "expected the numbers of vertices, faces and edges, found " + quoted(row.rest()));
    }
    double of_faces_or_edges = 0;
    for (int i = 0; i < 2 && row.read(of_faces_or_edges);) ++i;
    if (!row.done() && *row.at() != '#') {
      source_.fail_at_line(line.data(),
                           "expected no more than the numbers of vertices, faces and edges, found " +
                               quoted(row.word()) + " after them; put # before a comment");
    }
    return count;
  }

  void read_kind(std::string_view letters, std::string_view line) {
    if (letters.starts_with("ST")) kind_.texture = true, letters.remove_prefix(2);
    if (letters.starts_with("C")) kind_.colour = true, letters.remove_prefix(1);
    if (letters.starts_with("N")) kind_.normals = true, letters.remove_prefix(1);
    if (letters.starts_with("4")) kind_.weight = true, letters.remove_prefix(1);
    if (!letters.empty()) {
      source_.fail_at_line(line.data(),
                           "unknown kind of OFF; known are OFF, COFF, NOFF, STOFF, 4OFF and mixtures");
    }
  }

  void read_vertex(std::string_view line, std::uint64_t count) {
    std::size_t width = 0;
    for (Row row(line); !row.done() && *row.at() != '#'; ++width) {
      double value = 0;
      if (!row.read(value))
        source_.fail_at_line(row.at(), quoted(Row(row).word()) +
                                           " is not a number; correct the line, or export the file again");
      table_.values.push_back(value);
    }
    if (table_.names.empty()) {
      table_.names = names(width, line);
      // A number takes two bytes or more, so that no line of many and no count of many makes this large.
      table_.values.reserve(std::min<std::size_t>(count * width, source_.bytes().size() / 2 + 1));
    }
    if (width != table_.width()) {
      source_.fail_at_line(line.data(), "this vertex has " + std::to_string(width) +
                                            " values where those before have " +
                                            std::to_string(table_.width()) +
                                            "; the count of vertices may be wrong, or the line incomplete");
    }
  }

  // Position, weight, normal, colour (3 or 4 numbers, also where no C announced it), texture.
  std::vector<std::string> names(std::size_t width, std::string_view line) const {
    std::vector<std::string> result = {"x", "y", "z"};
    if (kind_.weight) result.push_back("w");
    if (kind_.normals) result.insert(result.end(), {"nx", "ny", "nz"});
    const std::size_t texture = kind_.texture ? 2 : 0;
    const std::size_t colour = width - std::min(width, result.size() + texture);
    if (width < result.size() + texture || (kind_.colour && colour == 0)) {
      source_.fail_at_line(line.data(), "this vertex has " + std::to_string(width) +
                                            " values, fewer than the first line of the file announces");
    }
    if (colour == 3 || colour == 4) {
      constexpr const char* channels[4] = {"red", "green", "blue", "alpha"};
      result.insert(result.end(), channels, channels + colour);
    } else {
      for (std::size_t i = 0; i < colour; ++i) result.push_back(fmt::format("column_{}", result.size() + 1));
    }
    if (kind_.texture) result.insert(result.end(), {"s", "t"});
    return result;
  }

  const Source& source_;
  const Run& run_;
  Lines lines_;
  OffKind kind_;
  Table table_;
};

}  // namespace

Cloud read_off(const Source& source, const Run& run) { return OffReader(source, run).read(); }

// After the counts and the vertices, a line for each face.
void read_off_faces(const Source& source, const Cloud& cloud, Faces& faces) {
  Lines lines(source.bytes());
  std::string_view line;
  long long vertices = -1, count = 0;
  std::size_t passed = 0;
  while (lines.next_filled(line, '#')) {
    Row row(line);
    if (vertices < 0) {
      if (!row.read(vertices)) {
        row.word();  // the keyword, whose line may hold the counts
        if (row.done() || !row.read(vertices)) {
          vertices = -1;
          continue;
        }
      }
      row.read(count);
      continue;
    }
    if (passed++ < cloud.points.size()) continue;
    if (count-- <= 0) return;
    long long corners = 0, id = 0;
    if (!row.read(corners)) source.fail_at_line(row.at(), "a face starts with its number of corners");
    for (; corners > 0; --corners) {
      const char* at = row.at();
      if (!row.read(id)) source.fail_at_line(row.at(), "a face with fewer corners than it says");
      faces.corner(id, at, Faces::Place::Line);
    }
    faces.close();
  }
}

}  // namespace rimline::io
