// SPDX-License-Identifier: GPL-3.0-or-later
// Dart throwing on a surface until no dart fits. The chart is cut into cells of less than a radius; each gets
// a dart, and what is left uncovered of it is cut into four and tried again (after White, Cline, Egbert 2007,
// who do so on the plane). Tile after tile, so that memory is touched in order and stays linear.
#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "sample/draft.h"
#include "sample/point_grid.h"
#include "sample/rim.h"

namespace rimline {
namespace {

struct Cell {
  UV centre;
  double du, dv;  // half of its sides

  UV corner(int x, int y) const { return {centre.u + x * du, centre.v + y * dv}; }
};

// Bounds for a cell seen on the surface, good for all that is cut from it.
struct Bounds {
  double half_u, half_v;          // half extents in units of length
  double least_gap, largest_gap;  // of the distances between points

  // Of a ball about the cell's centre that holds it.
  double radius() const { return std::sqrt(half_u * half_u + half_v * half_v); }
};

struct Piece {
  Cell cell;
  Bounds bounds;
};

class DartThrower {
 public:
  DartThrower(const AnalyticSurface& surface, const Density& density, const Run& run, std::size_t expected)
      : surface_(surface),
        density_(density),
        run_(run),
        random_(run.seed, 1),
        expected_(expected),
        length_([&](UV a, UV b) { return distance(surface.at(a), surface.at(b)) / spacing_between(a, b); }),
        rim_(surface, length_, density.spacing / 2, surface.at),
        placed_(1.5 * blue_radius * density.spacing, expected + expected / 8) {}

  BlueNoise throw_all() {
    BlueNoise result;
    for (const auto& rim : walk_rims(surface_, length_, 1)) {
      auto& loop = result.draft.loops.emplace_back();
      for (const UV at : rim) {
        loop.push_back(static_cast<Index>(uv_.size()));
        place(at, surface_.at(at));
      }
    }
    rim_count_ = static_cast<Index>(uv_.size());
    constexpr int first_cut = 16;  // so that three probes see what a cell is like
    const Box& box = surface_.box;
    const double du = box.width() / (2 * first_cut), dv = box.height() / (2 * first_cut);
    for (int i = 0; i < first_cut; ++i) {
      for (int j = 0; j < first_cut; ++j) {
        fill_tiles({{box.low.u + (2 * i + 1) * du, box.low.v + (2 * j + 1) * dv}, du, dv});
      }
    }
    fill();
    result.draft.points = placed_.take_points();
    result.uv = std::move(uv_);
    return result;
  }

 private:
  double spacing_between(UV a, UV b) const {
    return density_.spacing_at(surface_, {(a.u + b.u) / 2, (a.v + b.v) / 2});
  }
  double gap_at(UV at) const { return blue_radius * density_.spacing_at(surface_, at); }

  void place(UV at, const Point& p) {
    uv_.push_back(at);
    gap_.push_back(gap_at(at));
    placed_.insert(p);
  }

  Bounds bounds_of(const Cell& cell) const {
    Bounds bounds{0, 0, gap_at(cell.centre), gap_at(cell.centre)};
    for (const UV at : {cell.centre, cell.corner(-1, -1), cell.corner(1, 1)}) {
      const Tangents t = surface_.tangents(at);
      bounds.half_u = std::max(bounds.half_u, 1.05 * norm(t.u) * cell.du);
      bounds.half_v = std::max(bounds.half_v, 1.05 * norm(t.v) * cell.dv);
      bounds.least_gap = std::min(bounds.least_gap, gap_at(at));
      bounds.largest_gap = std::max(bounds.largest_gap, gap_at(at));
    }
    return bounds;
  }

  bool outside(const Cell& cell) const {
    return surface_.depth(cell.centre) < -std::sqrt(cell.du * cell.du + cell.dv * cell.dv);
  }

  // Cuts a cell in two across its longer side until no side is longer than `longest` gaps, and hands the
  // pieces on.
  template <class Use>
  void cut(const Cell& cell, double longest, const Use& use) {
    if (outside(cell)) return;
    const Bounds bounds = bounds_of(cell);
    if (2 * std::max(bounds.half_u, bounds.half_v) <= longest * bounds.least_gap)
      return use(Piece{cell, bounds});
    const bool across_u = bounds.half_u >= bounds.half_v;
    for (const int half : {-1, 1}) {
      Cell piece = cell;
      (across_u ? piece.du : piece.dv) /= 2;
      (across_u ? piece.centre.u : piece.centre.v) += half * (across_u ? piece.du : piece.dv);
      cut(piece, longest, use);
    }
  }

  // Cuts a piece into equal cells of at most 0.7 gaps: there one dart nearly covers its cell.
  void cut_evenly(const Piece& piece, std::vector<Piece>& cells) const {
    const auto& [cell, bounds] = piece;
    const double leaf = 0.7 * bounds.least_gap;
    const int columns = std::max(1, static_cast<int>(std::ceil(2 * bounds.half_u / leaf)));
    const int rows = std::max(1, static_cast<int>(std::ceil(2 * bounds.half_v / leaf)));
    const Bounds small{bounds.half_u / columns, bounds.half_v / rows, bounds.least_gap, bounds.largest_gap};
    const double du = cell.du / columns, dv = cell.dv / rows;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        const UV centre{cell.centre.u - cell.du + (2 * i + 1) * du,
                        cell.centre.v - cell.dv + (2 * j + 1) * dv};
        cells.push_back({{centre, du, dv}, small});
      }
    }
  }

  // Cuts a cell into tiles of 40 gaps, which are small enough for the cache, those into blocks of 5 with one
  // set of bounds, and those into the cells that get darts. Small tiles are filled together: one by one
  // their borders would order the points.
  void fill_tiles(const Cell& cell) {
    constexpr double tile = 40, block = 5;
    constexpr std::size_t enough = 2048;  // cells to fill at once
    cut(cell, tile, [&](const Piece& piece) {
      cut(piece.cell, block, [&](const Piece& small) { cut_evenly(small, active_); });
      if (active_.size() >= enough) fill();
    });
  }

  void fill() {
    run_.progress(Stage::Arrange, std::min(uv_.size(), expected_), expected_);
    for (int level = 0; level < 7 && !active_.empty(); ++level) {
      random_.shuffle(active_);
      left_.clear();
      for (const Piece& piece : active_) try_piece(piece);
      active_.swap(left_);
    }
    active_.clear();
  }

  // Throws a dart into the cell and puts aside what remains uncovered of it.
  void try_piece(const Piece& piece) {
    const auto& [cell, bounds] = piece;
    if (outside(cell)) return;
    const Point centre = surface_.at(cell.centre);
    const double reach = bounds.largest_gap + bounds.radius();
    near_.clear();
    placed_.near(centre, reach, [&](Index i) {
      if (squared_distance(placed_.points()[i], centre) < reach * reach) near_.push_back(i);
    });
    if (covered(centre, bounds)) return;
    throw_dart(cell, centre, reach);

    const Tangents t = surface_.tangents(cell.centre);
    const Point to_u = cell.du / 2 * t.u, to_v = cell.dv / 2 * t.v;
    const Bounds half{bounds.half_u / 2, bounds.half_v / 2, bounds.least_gap, bounds.largest_gap};
    for (const int x : {-1, 1}) {
      for (const int y : {-1, 1}) {
        if (covered(centre + x * to_u + y * to_v, half)) continue;
        left_.push_back(
            {{{cell.centre.u + x * cell.du / 2, cell.centre.v + y * cell.dv / 2}, cell.du / 2, cell.dv / 2},
             half});
      }
    }
  }

  // Whether one of the near points leaves no room in a cell for another point.
  bool covered(const Point& centre, const Bounds& bounds) const {
    const double radius = bounds.radius();
    return std::any_of(near_.begin(), near_.end(), [&](Index i) {
      const double room = std::min(bounds.least_gap, gap_[i]) - radius;
      return room > 0 && squared_distance(placed_.points()[i], centre) < room * room;
    });
  }

  void throw_dart(const Cell& cell, const Point& centre, double reach) {
    const UV at{cell.centre.u + cell.du * (2 * random_.uniform() - 1),
                cell.centre.v + cell.dv * (2 * random_.uniform() - 1)};
    if (surface_.depth(at) <= 0) return;
    const Point p = surface_.at(at);
    const double gap = gap_at(at);
    // What is known of the neighbours ends at `reach`: enough unless the bounds were too tight.
    if (distance(p, centre) + gap > reach) return;
    bool near_rim = false;  // points of a rim are so close that half a spacing from it there is one in reach
    for (const Index i : near_) {
      const double least = std::min(gap, gap_[i]);
      if (squared_distance(placed_.points()[i], p) < least * least) return;
      near_rim = near_rim || i < rim_count_;
    }
    if (near_rim && rim_.within_half_spacing(at, density_.spacing_at(surface_, at))) return;
    near_.push_back(static_cast<Index>(uv_.size()));
    place(at, p);
  }

  const AnalyticSurface& surface_;
  const Density& density_;
  const Run& run_;
  Random random_;
  std::size_t expected_;
  StepLength length_;
  RimDistance rim_;
  PointGrid placed_;
  std::vector<UV> uv_;
  std::vector<double> gap_;  // least distance to others, of every point
  Index rim_count_ = 0;      // the first points are those of the rims
  std::vector<Piece> active_, left_;
  std::vector<Index> near_;  // points about the cell at hand
};

}  // namespace

BlueNoise blue_noise(const AnalyticSurface& surface, const Density& density, const Run& run,
                     std::size_t expected) {
  return DartThrower(surface, density, run, expected).throw_all();
}

}  // namespace rimline
