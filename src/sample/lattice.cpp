// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of points at equal steps. Where the chart is a sheet the rows are its lines v = const and all take the
// same steps; about an axis they are rings, and the number of steps follows their circumference.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "sample/draft.h"
#include "sample/rim.h"

namespace rimline {
namespace {

// The steps that divide the box evenly and come nearest to those asked for.
struct Steps {
  double along,
      across;        // as taken along u and across the rows, in the unit of length of the chart or surface
  double first_row;  // v of row 0
  int rows;          // rows 0 to rows - 1, those on a rim included
};

Steps divide(const AnalyticSurface& surface, double along, double across) {
  const double height = surface.box.height(), low = surface.box.low.v;
  const bool low_pole = surface.low_end == End::Pole, high_pole = surface.high_end == End::Pole;
  const double halves = 0.5 * (static_cast<int>(low_pole) +
                               static_cast<int>(high_pole));  // rows stop half a step before a pole
  const int whole = std::max(2, static_cast<int>(std::lround(height / across - halves)));
  const double step = height / (whole + halves);
  const bool joined = surface.low_end == End::Periodic;
  if (surface.rows == Rows::Even) {
    const double width = surface.box.width();
    along = width / std::max(2L, std::lround(width / along));
  }
  return {along, step, low_pole ? low + step / 2 : low, joined ? whole : whole + 1};
}

class Lattice {
 public:
  Lattice(const AnalyticSurface& surface, const Steps& steps, const Run& run, bool phases)
      : surface_(surface),
        steps_(steps),
        run_(run),
        phases_(phases),
        length_([this](UV a, UV b) { return step_length(a, b); }),
        rim_(surface, length_, std::max(steps.along, steps.across) / 2, [this](UV at) { return place(at); }) {
  }

  Draft fill(std::size_t expected) {
    Draft draft;
    draft.points.reserve(expected + expected / 8);
    for (const auto& rim : walk_rims(surface_, length_, 1)) {
      auto& loop = draft.loops.emplace_back();
      for (const UV at : rim) {
        loop.push_back(static_cast<Index>(draft.points.size()));
        draft.points.push_back(surface_.at(at));
      }
    }
    for (int i = 0; i < steps_.rows; ++i) {
      run_.progress(Stage::Arrange, std::min(draft.points.size(), expected), expected);
      fill_row(i, draft);
    }
    return draft;
  }

 private:
  bool rings() const { return surface_.rows == Rows::Rings; }

  // Where distances are taken: on the sheet itself, or in space.
  Point place(UV at) const { return rings() ? surface_.at(at) : Point{at.u, at.v, 0}; }

  Point direction(UV at) const {
    const Point t = rings() ? surface_.tangents(at).u : Point{1, 0, 0};
    return 1 / norm(t) * t;
  }

  double step_length(UV a, UV b) const {
    const Point d = place(b) - place(a);
    const double along = dot(d, direction({(a.u + b.u) / 2, (a.v + b.v) / 2}));
    const double across2 = std::max(0.0, dot(d, d) - along * along);
    return std::sqrt(along * along / (steps_.along * steps_.along) +
                     across2 / (steps_.across * steps_.across));
  }

  // Rows that the twisted seam joins begin at the same phase.
  double phase(int row) const {
    if (!phases_) return 0;
    const int stream = surface_.twisted ? std::min(row, steps_.rows - 1 - row) : row;
    return Random(run_.seed, 16 + static_cast<std::uint64_t>(stream)).uniform();
  }

  void fill_row(int row, Draft& draft) {
    const double v = steps_.first_row + row * steps_.across, width = surface_.box.width();
    const double unit = rings() ? norm(surface_.tangents({surface_.box.low.u, v}).u) : 1;
    const int count = std::max(3, static_cast<int>(std::lround(width * unit / steps_.along)));
    const double start = phase(row);
    for (int j = 0; j < count; ++j) {
      const UV at{surface_.box.low.u + width * (j + start) / count, v};
      if (surface_.depth(at) <= 0 || rim_.within_half(at, steps_.along, steps_.across, direction(at)))
        continue;
      draft.points.push_back(surface_.at(at));
    }
  }

  const AnalyticSurface& surface_;
  Steps steps_;
  const Run& run_;
  bool phases_;
  StepLength length_;
  RimDistance rim_;
};

}  // namespace

Draft lattice(const AnalyticSurface& surface, double spacing, double aspect, const Run& run,
              std::size_t expected) {
  Steps steps = divide(surface, spacing / std::sqrt(aspect), spacing * std::sqrt(aspect));
  // Few rows fit evenly only at another distance: the count is kept and the aspect gives way.
  if (aspect > 1) steps = divide(surface, spacing * spacing / steps.across, steps.across);
  return Lattice(surface, steps, run, aspect > 1).fill(expected);
}

}  // namespace rimline
