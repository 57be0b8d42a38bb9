// SPDX-License-Identifier: GPL-3.0-or-later
// STL: triangles without shared vertices; corners with equal coordinates become one point, in order of
// appearance.
#include <bit>
#include <cstdint>
#include <cstring>

#include "io/fields.h"
#include "io/lines.h"
#include "io/readers.h"
#include "io/telling.h"

namespace rimline::io {
namespace {

constexpr std::size_t header_size = 84, record_size = 50;

// The set of points seen so far: open addressing with linear steps, at most half full.
class Corners {
 public:
  // Returns the id of the point at that place.
  Index add(Point p) {
    if (2 * (points_.size() + 1) > slots_.size()) grow();
    std::size_t slot = hash(p) & (slots_.size() - 1);
    while (slots_[slot] != none) {
      if (same(points_[static_cast<std::size_t>(slots_[slot])], p)) return slots_[slot];
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = static_cast<Index>(points_.size());
    points_.push_back(p);
    return slots_[slot];
  }

  std::vector<Point>& points() { return points_; }

 private:
  // Adding 0 turns -0 into 0. NaN is equal to NaN of the same bits here.
  static std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }
  static bool same(Point a, Point b) {
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
  }
  static std::size_t hash(Point p) {
    std::uint64_t h = 0;
    for (const double v : {p.x, p.y, p.z}) {
      h = (h ^ bits(v)) * 0x9e3779b97f4a7c15u;  // 2^64 over the golden ratio
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
  void grow() {
    slots_.assign(std::max<std::size_t>(1024, 2 * slots_.size()), none);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      std::size_t slot = hash(points_[i]) & (slots_.size() - 1);
      while (slots_[slot] != none) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<Index>(i);
    }
  }

  std::vector<Point> points_;
  std::vector<Index> slots_;
};

std::uint32_t little_endian_32(const char* at) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(at[i])} << (8 * i);
  return value;
}

double float_at(const char* at) { return std::bit_cast<float>(little_endian_32(at)); }

bool is_binary(const Source& source) { return is_stl_binary(source.bytes()) || !is_text(source.bytes()); }

// Calls corner(place, at) for each corner of each triangle, in the order of the file.
template <class Corner>
void visit_binary(const Source& source, const Run& run, const Corner& corner) {
  if (source.bytes().size() < header_size)
    source.fail("is shorter than the 84 bytes of an STL header; truncated?");
  const std::uint64_t count = little_endian_32(source.begin() + 80);
  if ((source.bytes().size() - header_size) / record_size < count) {
    source.fail("ends at byte " + std::to_string(source.bytes().size()) + ", before the " +
                std::to_string(count) +
                " triangles that the STL header announces; the file is truncated, or not an STL");
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % items_per_look == 0) source.progress(run, i, count);
    const char* at = source.begin() + header_size + i * record_size + 12;  // after the normal
    for (int c = 0; c < 3; ++c, at += 12) corner(Point{float_at(at), float_at(at + 4), float_at(at + 8)}, at);
  }
}

template <class Corner>
void visit_text(const Source& source, const Run& run, const Corner& corner) {
  Lines lines(source.bytes());
  std::string_view line;
  bool ended = false;
  for (std::size_t number = 0; lines.next_filled(line); ++number) {
    if (number % items_per_look == 0) source.progress(run, lines.at());
    Row row(line);
    const std::string_view keyword = row.word();
    ended = keyword == "endsolid" || (ended && keyword != "facet");
    if (keyword != "vertex") continue;
    Point p;
    if (!row.read(p.x) || !row.read(p.y) || !row.read(p.z) || !row.done()) {
      source.fail_at_line(line.data(), "a vertex needs three numbers: " + quoted(line));
    }
    corner(p, line.data());
  }
  if (!ended)
    source.fail("the STL has no 'endsolid' at its end; the file is truncated: copy or export it again");
}

template <class Corner>
void visit(const Source& source, const Run& run, const Corner& corner) {
  is_binary(source) ? visit_binary(source, run, corner) : visit_text(source, run, corner);
}

}  // namespace

bool is_stl_binary(std::string_view bytes) {
  if (bytes.size() < header_size) return false;
  return bytes.size() == header_size + record_size * std::uint64_t{little_endian_32(bytes.data() + 80)};
}

Cloud read_stl(const Source& source, const Run& run) {
  Corners corners;
  visit(source, run, [&](Point p, const char*) {
    check_point_count(source, corners.points().size() + 1);
    corners.add(p);
  });
  // Text may hold more digits than a float; they are kept.
  const bool binary = is_binary(source);
  return {std::move(corners.points()),
          binary ? Scalar::Float32 : Scalar::Float64,
          {},
          binary ? "STL, binary" : "STL, ascii"};
}

void read_stl_faces(const Source& source, const Cloud&, Faces& faces) {
  Corners corners;
  int count = 0;
  visit(source, Run{}, [&](Point p, const char* at) {
    faces.corner(corners.add(p), at, Faces::Place::Byte);
    if (++count % 3 == 0) faces.close();
  });
}

}  // namespace rimline::io
