// SPDX-License-Identifier: GPL-3.0-or-later
// XYZ, TXT, CSV, PTS: a point a line. The first line with numbers sets the number of columns; every other
// line must have as many.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "io/cells.h"
#include "io/column_names.h"
#include "io/fields.h"
#include "io/lines.h"
#include "io/readers.h"
#include "io/table.h"

namespace rimline::io {
namespace {

[[noreturn]] void fail_row(std::string_view line, std::size_t width, CellStyle style, const Source& source) {
  if (!style.decimal_commas && style_of(line).decimal_commas) {
    source.fail_at_line(line.data(),
                        "numbers with decimal commas, where the lines before have decimal points; write all "
                        "of them alike");
  }
  const auto cells = split(line, style);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty()) {
      source.fail_at_line(line.data(), "value " + std::to_string(i + 1) +
                                           " is empty; fill it (nan is allowed) " + "or remove the line");
    }
    if (!is_number(cells[i], style)) {
      source.fail_at_line(line.data(),
                          quoted(cells[i]) + " is not a number; correct it, or put # before a comment");
    }
  }
  source.fail_at_line(line.data(), "has " + std::to_string(cells.size()) +
                                       " values where the lines before have " + std::to_string(width) +
                                       "; complete or remove the line");
}

// The number of points that a line of its own announces, as PTS has it before each scan.
std::optional<std::uint64_t> count_of(const std::vector<std::string_view>& cells) {
  std::uint64_t count = 0;
  if (cells.size() != 1) return std::nullopt;
  const char* end = cells[0].data() + cells[0].size();
  if (read_number(cells[0].data(), end, count) != end) return std::nullopt;
  return count;
}

// The lines before the numbers.
class TextReader {
 public:
  TextReader(const Source& source, const Run& run)
      : source_(source), run_(run), lines_(source.bytes()), style_(style_of(source.bytes())) {}

  Cloud read() {
    std::string_view line;
    for (std::size_t number = 0; lines_.next(line); ++number) {
      if (number % items_per_look == 0) source_.progress(run_, lines_.at());
      const char* first = skip_blanks(line.data(), line.data() + line.size());
      line.remove_prefix(static_cast<std::size_t>(first - line.data()));
      if (line.empty()) continue;
      if (is_comment(line)) {
        if (table_.names.empty()) last_comment_ = line;
        continue;
      }
      if (table_.names.empty() && !start_table(line)) continue;
      if (!read_cells(line, columns_, style_, table_.values)) next_block(line);
    }
    if (table_.names.empty()) source_.fail("has no points: no line of numbers");
    check_count();
    return finish();
  }

 private:
  // True on the first row of numbers; before it come a header and, in PTS files, the number of points.
  bool start_table(std::string_view line) {
    const auto cells = split(line, style_);
    const bool numbers =
        std::all_of(cells.begin(), cells.end(), [&](auto cell) { return is_number(cell, style_); });
    if (!numbers && header_.empty()) {
      if (line.starts_with("sep=")) return false;  // of a spreadsheet
      header_ = header_names(line);
      header_line_ = line;
      return false;
    }
    if (!numbers) {
      if (!leave_text_out(line)) fail_row(line, 0, style_, source_);
      reserve(line);
      return true;
    }
    if (const auto count = count_of(cells); count && !count_) {
      count_ = count;
      count_line_ = line;
      return false;
    }
    if (cells.size() < 3) {
      source_.fail_at_line(line.data(), "has " + std::to_string(cells.size()) +
                                            (cells.size() == 1 ? " value" : " values") +
                                            "; a point needs at least x, y and z");
    }
    name_columns(cells.size(), line);
    columns_.count = cells.size();
    reserve(line);
    return true;
  }

  void reserve(std::string_view line) {
    const std::size_t rows = source_.bytes().size() / (line.size() + 1) + 1;
    table_.values.reserve(rows * table_.width());
  }

  // Under a header, columns that start with a text (names of points, kinds of trees) are no properties. False
  // where the line does not fit the header, or a coordinate is no number.
  bool leave_text_out(std::string_view line) {
    const auto coordinates = find_coordinates(header_);
    auto cells = split(line, style_);
    if (cells.size() != header_.size()) cells = split_hard(line, style_);
    if (!coordinates || cells.size() != header_.size()) return false;
    for (const std::size_t c : coordinates->columns) {
      if (!is_number(cells[c], style_)) return false;
    }
    columns_ = {cells.size(), std::vector<char>(cells.size())};
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (is_number(cells[c], style_)) {
        table_.names.push_back(header_[c]);
      } else {
        columns_.text[c] = 1;
        left_out_ += (left_out_.empty() ? "" : ", ") + header_[c];
      }
    }
    return true;
  }

  // In PTS files another scan may follow, with its own number of points; any other line is wrong.
  void next_block(std::string_view line) {
    const auto count = count_of(split(line, style_));
    const std::size_t whole = table_.values.size() / table_.width() * table_.width();
    table_.values.resize(whole);
    if (!count || !count_) fail_row(line, table_.width(), style_, source_);
    check_count();
    block_begin_ = table_.rows();
    count_ = count;
    count_line_ = line;
  }

  void name_columns(std::size_t width, std::string_view line) {
    if (!header_.empty() && !find_coordinates(header_)) {
      source_.fail_at_line(header_line_.data(), quoted(header_line_) +
                                                    " is neither numbers nor column names with " +
                                                    "x, y and z; name the columns, or put # before the line");
    }
    if (!header_.empty() && header_.size() != width) {
      source_.fail_at_line(line.data(), "has " + std::to_string(width) + " values where the header names " +
                                            std::to_string(header_.size()) +
                                            " columns; name each column, or remove the header");
    }
    // "//X Y Z R G B" and "# x y z intensity" are common too.
    if (header_.empty() && !last_comment_.empty()) {
      auto names = header_names(last_comment_);
      if (names.size() == width && find_coordinates(names)) header_ = std::move(names);
    }
    table_.names = header_.empty() ? std::vector<std::string>(width) : header_;
  }

  // Columns get their names, and the cloud tells how.
  Cloud finish() {
    std::string warning = header_.empty() ? guess_names(table_) : "";
    const auto coordinates = find_coordinates(table_.names);
    const auto [x, y, z] = coordinates->columns;
    const std::string chosen = chosen_columns(coordinates->columns);
    if (!coordinates->warning.empty()) warning = coordinates->warning;
    table_.names[x] = std::string("x");
    table_.names[y] = std::string("y");
    table_.names[z] = std::string("z");
    Cloud cloud = cloud_from_table(table_, coordinates->columns, source_, run_);
    cloud.coordinates = chosen;
    cloud.unit = coordinates->unit;
    if (!warning.empty()) cloud.warnings.push_back(source_.name() + ": " + warning);
    if (!left_out_.empty())
      cloud.warnings.push_back(source_.name() + ": columns of text are left out: " + left_out_);
    return cloud;
  }

  // By their names and places in the file.
  std::string chosen_columns(std::array<std::size_t, 3> of_table) const {
    if (header_.empty())
      return fmt::format("columns {}, {} and {}", of_table[0] + 1, of_table[1] + 1, of_table[2] + 1);
    const auto [x, y, z] = find_coordinates(header_)->columns;
    return fmt::format("{}, {}, {} (columns {}, {} and {})", header_[x], header_[y], header_[z], x + 1, y + 1,
                       z + 1);
  }

  void check_count() const {
    const std::size_t rows = table_.rows() - block_begin_;
    if (!count_ || *count_ == rows) return;
    source_.fail_at_line(count_line_.data(), "announces " + std::to_string(*count_) + " points, but " +
                                                 std::to_string(rows) +
                                                 " follow; the file is truncated, or remove that line");
  }

  const Source& source_;
  const Run& run_;
  Lines lines_;
  CellStyle style_;
  std::string_view last_comment_, header_line_, count_line_;
  std::vector<std::string> header_;
  std::optional<std::uint64_t> count_;  // of the scan that begins at block_begin_
  std::size_t block_begin_ = 0;
  Columns columns_;
  std::string left_out_;  // names of columns of text
  Table table_;
};

}  // namespace

Cloud read_text(const Source& source, const Run& run) { return TextReader(source, run).read(); }

}  // namespace rimline::io
