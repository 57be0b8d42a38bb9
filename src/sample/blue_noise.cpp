// SPDX-License-Identifier: GPL-3.0-or-later
// Dart throwing on a surface until no dart fits. The chart is cut into cells of less than a radius; each gets
// a dart, and what is left uncovered of it is cut into four and tried again (after White, Cline, Egbert 2007,
// who do so on the plane). Tile after tile, so that memory is touched in order and stays linear.
#include <algorithm>
#include <cmath>

#include "random.h"
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

// A cell seen on the surface.
struct Patch {
  Point centre;
  double half_u, half_v;          // half extents in units of length
  double radius;                  // of a ball about the centre that holds it
  double least_gap, largest_gap;  // of the distances between points, over the cell
};

class DartThrower {
 public:
  DartThrower(const Surface& surface, const Density& density, const Run& run, std::size_t expected)
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
    constexpr int first_cut = 16;  // so that three probes see what a cell is like
    const Box& box = surface_.box;
    const double du = box.width() / (2 * first_cut), dv = box.height() / (2 * first_cut);
    for (int i = 0; i < first_cut; ++i) {
      for (int j = 0; j < first_cut; ++j) {
        tiles({{box.low.u + (2 * i + 1) * du, box.low.v + (2 * j + 1) * dv}, du, dv});
      }
    }
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

  Patch look_at(const Cell& cell) const {
    Patch patch{surface_.at(cell.centre), 0, 0, 0, gap_at(cell.centre), 0};
    patch.largest_gap = patch.least_gap;
    for (const UV at : {cell.centre, cell.corner(-1, -1), cell.corner(1, 1)}) {
      const Tangents t = surface_.tangents(at);
      patch.half_u = std::max(patch.half_u, norm(t.u) * cell.du);
      patch.half_v = std::max(patch.half_v, norm(t.v) * cell.dv);
      if (density_.change == DensityChange::None) continue;
      patch.least_gap = std::min(patch.least_gap, gap_at(at));
      patch.largest_gap = std::max(patch.largest_gap, gap_at(at));
    }
    patch.radius = 1.05 * std::hypot(patch.half_u, patch.half_v);
    return patch;
  }

  bool outside(const Cell& cell) const { return surface_.depth(cell.centre) < -std::hypot(cell.du, cell.dv); }

  // Cuts a cell in two across its longer side until no side is longer than `longest` gaps, and hands the
  // pieces on.
  template <class Use>
  void cut(const Cell& cell, double longest, const Use& use) {
    if (outside(cell)) return;
    const Patch patch = look_at(cell);
    const double side = 2 * std::max(patch.half_u, patch.half_v);
    if (side <= longest * patch.least_gap) return use(cell);
    const bool across_u = patch.half_u >= patch.half_v;
    for (const int half : {-1, 1}) {
      Cell piece = cell;
      (across_u ? piece.du : piece.dv) /= 2;
      (across_u ? piece.centre.u : piece.centre.v) += half * (across_u ? piece.du : piece.dv);
      cut(piece, longest, use);
    }
  }

  void tiles(const Cell& cell) {
    constexpr double tile = 40, leaf = 0.7;  // in gaps; below 0.7 one dart nearly covers its cell
    cut(cell, tile, [&](const Cell& piece) {
      run_.progress(Stage::Arrange, std::min(uv_.size(), expected_), expected_);
      std::vector<Cell> active;
      cut(piece, leaf, [&](const Cell& small) { active.push_back(small); });
      fill(active);
    });
  }

  void fill(std::vector<Cell>& active) {
    std::vector<Cell> left;
    for (int level = 0; level < 7 && !active.empty(); ++level) {
      random_.shuffle(active);
      left.clear();
      for (const Cell& cell : active) try_cell(cell, left);
      active.swap(left);
    }
  }

  // Throws a dart into the cell and appends what remains uncovered of it.
  void try_cell(const Cell& cell, std::vector<Cell>& left) {
    const Patch patch = look_at(cell);
    const double reach = patch.largest_gap + 2 * patch.radius;
    near_.clear();
    placed_.near(patch.centre, reach, [&](Index i) {
      if (squared_distance(placed_.points()[i], patch.centre) < reach * reach) near_.push_back(i);
    });
    if (covered(patch)) return;
    throw_dart(cell, patch, reach);
    for (const int x : {-1, 1}) {
      for (const int y : {-1, 1}) {
        const Cell quarter{
            {cell.centre.u + x * cell.du / 2, cell.centre.v + y * cell.dv / 2}, cell.du / 2, cell.dv / 2};
        if (!outside(quarter) && !covered(look_at(quarter))) left.push_back(quarter);
      }
    }
  }

  bool covered(const Patch& patch) const {
    return std::any_of(near_.begin(), near_.end(), [&](Index i) {
      const double room = std::min(patch.least_gap, gap_[i]) - patch.radius;
      return room > 0 && squared_distance(placed_.points()[i], patch.centre) < room * room;
    });
  }

  void throw_dart(const Cell& cell, const Patch& patch, double reach) {
    const UV at{cell.centre.u + cell.du * (2 * random_.uniform() - 1),
                cell.centre.v + cell.dv * (2 * random_.uniform() - 1)};
    if (surface_.depth(at) <= 0) return;
    const Point p = surface_.at(at);
    const double gap = gap_at(at);
    // What is known of the neighbours ends at `reach`: true unless the patch was larger than it seemed.
    if (distance(p, patch.centre) + gap > reach) return;
    for (const Index i : near_) {
      const double least = std::min(gap, gap_[i]);
      if (squared_distance(placed_.points()[i], p) < least * least) return;
    }
    if (rim_.within_half_spacing(at, density_.spacing_at(surface_, at))) return;
    near_.push_back(static_cast<Index>(uv_.size()));
    place(at, p);
  }

  const Surface& surface_;
  const Density& density_;
  const Run& run_;
  Random random_;
  std::size_t expected_;
  StepLength length_;
  RimDistance rim_;
  PointGrid placed_;
  std::vector<UV> uv_;
  std::vector<double> gap_;  // least distance to others, of every point
  std::vector<Index> near_;  // points about the cell at hand
};

}  // namespace

BlueNoise blue_noise(const Surface& surface, const Density& density, const Run& run, std::size_t expected) {
  return DartThrower(surface, density, run, expected).throw_all();
}

}  // namespace rimline
