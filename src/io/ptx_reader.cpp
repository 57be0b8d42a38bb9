// SPDX-License-Identifier: GPL-3.0-or-later
// PTX (Leica): several scans, each with the size of its raster, the pose of the scanner, a matrix, and a line
// for each cell: x y z, then intensity, then possibly r g b. A cell without a return is 0 0 0.
#include <array>
#include <limits>

#include "io/fields.h"
#include "io/lines.h"
#include "io/readers.h"

namespace rimline::io {
namespace {

using Matrix = std::array<std::array<double, 4>, 4>;

struct Scan {
  std::uint64_t columns = 0, rows = 0;
  Matrix matrix{};  // of row vectors: its last row is the translation
};

class PtxReader {
 public:
  PtxReader(const Source& source, const Run& run) : source_(source), run_(run), lines_(source.bytes()) {}

  Cloud read() {
    std::string_view line;
    while (lines_.next_filled(line)) read_scan(line);
    Cloud cloud;
    cloud.points = std::move(points_);
    cloud.columns.push_back(make_column("intensity", intensity_));
    const char* const names[] = {"red", "green", "blue"};
    for (std::size_t c = 0; width_ == 7 && c < 3; ++c)
      cloud.columns.push_back(make_column(names[c], colour_[c]));
    cloud.columns.push_back(make_column("scan", scan_));
    cloud.columns.push_back(make_column("column", column_));
    cloud.columns.push_back(make_column("row", row_));
    cloud.format = "PTX, " + std::to_string(scans_) + (scans_ == 1 ? " scan" : " scans");
    cloud.coordinates = "columns 1, 2 and 3, moved by the matrix of the scan";
    return cloud;
  }

 private:
  std::string_view next() {
    std::string_view line;
    if (!lines_.next_filled(line))
      source_.fail("is a PTX file that ends within a scan; it is truncated: export it again");
    return line;
  }

  template <std::size_t count>
  std::array<double, count> numbers(std::string_view line, const char* what) const {
    std::array<double, count> values{};
    Row row(line);
    for (double& value : values) {
      if (!row.read(value)) source_.fail_at_line(line.data(), std::string(what) + "; export the scan again");
    }
    if (!row.done()) source_.fail_at_line(line.data(), std::string(what) + "; export the scan again");
    return values;
  }

  std::uint64_t side(std::string_view line) const {
    std::uint64_t value = 0;
    Row row(line);
    if (!row.read(value) || !row.done()) {
      source_.fail_at_line(line.data(),
                           "a scan of a PTX starts with its number of columns and of rows, each on "
                           "a line; the scan before may have a line too many");
    }
    check_point_count(source_, value);
    return value;
  }

  Scan read_head(std::string_view line) {
    Scan scan;
    scan.columns = side(line);
    scan.rows = side(next());
    for (int i = 0; i < 4; ++i) numbers<3>(next(), "the scanner's place and axes have three numbers each");
    for (auto& row : scan.matrix) row = numbers<4>(next(), "a row of the scan's matrix has four numbers");
    return scan;
  }

  void read_scan(std::string_view line) {
    const Scan scan = read_head(line);
    const std::uint64_t count = scan.columns * scan.rows;  // both below 2^31
    constexpr std::size_t least_bytes = 8;                 // "0 0 0 0" and a line end
    if (count > (source_.bytes_from(lines_.at()) + 1) / least_bytes) {
      source_.fail_at_line(line.data(), "is a PTX file whose scan here announces " + std::to_string(count) +
                                            " cells, more than follow; it is truncated: export it again");
    }
    check_point_count(source_, points_.size() + count);
    for (std::uint64_t i = 0; i < count; ++i) {
      if (i % items_per_look == 0) source_.progress(run_, lines_.at());
      read_cell(next(), scan, i);
    }
    ++scans_;
  }

  void read_cell(std::string_view line, const Scan& scan, std::uint64_t cell) {
    std::array<double, 7> v{};
    Row row(line);
    std::size_t width = 0;
    while (width < v.size() && row.read(v[width])) ++width;
    if (!row.done() || (width != 4 && width != 7)) {
      source_.fail_at_line(line.data(),
                           "a cell of a PTX has x y z intensity, then maybe r g b; this line has " +
                               quoted(line) + "; export the scan again");
    }
    if (width_ == 0) width_ = width;
    if (width != width_) {
      source_.fail_at_line(line.data(), "this cell has " + std::to_string(width) +
                                            " values where those before " + "have " + std::to_string(width_) +
                                            "; export the scans alike");
    }
    points_.push_back(placed(v, scan.matrix));
    intensity_.push_back(v[3]);
    for (std::size_t c = 0; width == 7 && c < 3; ++c) colour_[c].push_back(colour(v[4 + c], line));
    scan_.push_back(static_cast<std::uint16_t>(std::min<std::size_t>(scans_, 65535)));
    column_.push_back(static_cast<std::uint32_t>(cell / scan.rows));
    row_.push_back(static_cast<std::uint32_t>(cell % scan.rows));
  }

  std::uint8_t colour(double value, std::string_view line) const {
    if (!(value >= 0 && value <= 255))
      source_.fail_at_line(line.data(), "a colour of a PTX is from 0 to 255");
    return static_cast<std::uint8_t>(value);
  }

  // A cell without a return has no place.
  static Point placed(const std::array<double, 7>& v, const Matrix& m) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (v[0] == 0 && v[1] == 0 && v[2] == 0) return {nan, nan, nan};
    const auto axis = [&](std::size_t c) {
      return v[0] * m[0][c] + v[1] * m[1][c] + v[2] * m[2][c] + m[3][c];
    };
    return {axis(0), axis(1), axis(2)};
  }

  const Source& source_;
  const Run& run_;
  Lines lines_;
  std::size_t scans_ = 0, width_ = 0;
  std::vector<Point> points_;
  std::vector<double> intensity_;
  std::array<std::vector<std::uint8_t>, 3> colour_;
  std::vector<std::uint16_t> scan_;
  std::vector<std::uint32_t> column_, row_;
};

}  // namespace

bool is_ptx(std::string_view bytes) {
  Lines lines(bytes.substr(0, 4096));
  std::string_view line;
  for (const std::size_t width : {1, 1, 3, 3, 3, 3, 4, 4, 4, 4}) {
    if (!lines.next_filled(line)) return false;
    Row row(line);
    double value = 0;
    std::size_t count = 0;
    while (row.read(value)) ++count;
    if (!row.done() || count != width) return false;
  }
  return true;
}

Cloud read_ptx(const Source& source, const Run& run) { return PtxReader(source, run).read(); }

}  // namespace rimline::io
