// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/atlas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "base/domain_traits.h"
#include "base/vec.h"
#include "map/angle_error.h"
#include "map/bisect.h"
#include "map/cut_graph.h"
#include "mesh/corner_angles.h"
#include "solve/sparse.h"

namespace rimline {
namespace {

// A vertex of the triangle that is smallest in the map relative to its area in space.
Index most_stretched(const OpenMesh& open, const std::vector<UV>& uv) {
  Index worst = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : open.mesh.triangles) {
    const UV e = uv[t[1]] - uv[t[0]], f = uv[t[2]] - uv[t[0]];
    const double area = triangle_area(open.points, t), ratio = (e.u * f.v - e.v * f.u) / area;
    if (!(area > 0) || !(ratio < least)) continue;
    least = ratio;
    worst = t[0];
  }
  return worst;
}

// The vertices of all loops but that of `vertex`.
std::vector<Index> other_rims(const OpenMesh& open, Index vertex) {
  std::vector<Index> rims;
  for (const Loop& loop : open.loops) {
    if (std::ranges::find(loop.points, vertex) != loop.points.end()) continue;
    rims.insert(rims.end(), loop.points.begin(), loop.points.end());
  }
  return rims;
}

// The inner vertex whose angles differ most from 2 pi, where that is much: a needle, or a fold.
Index sharpest_cone(const OpenMesh& open) {
  constexpr double much = 2;  // radians
  constexpr double full = 2 * std::numbers::pi;
  std::vector<double> angle(open.points.size(), 0);
  for (const auto& [a, b, c] : open.mesh.triangles) {
    const auto own = corner_angles(open.points[a], open.points[b], open.points[c]);
    angle[a] += own[0], angle[b] += own[1], angle[c] += own[2];
  }
  for (const Loop& loop : open.loops) {
    for (const Index v : loop.points) angle[v] = full;
  }
  const auto off = [&](double sum) { return std::abs(full - sum); };
  const auto sharpest = std::ranges::max_element(angle, {}, off);
  return off(*sharpest) > much ? static_cast<Index>(sharpest - angle.begin()) : none;
}

constexpr std::size_t most_slits = 12;  // in one chart
constexpr Index large = 200'000;  // vertices; the outline first, all that is tried above it, keeps angles

}  // namespace

Atlas::Atlas(const ChartOptions& options, const AngleError& most_error, std::int64_t triangles,
             const Run& run)
    : options_(options),
      run_(run),
      most_error_(most_error),
      is_free_(options.charts != 1),
      triangles_(triangles) {}

Atlas::Outlook Atlas::look(const OpenMesh& open) {
  constexpr double rough = 1e-6;  // residual of maps that only decide where to cut
  looks_left_ -= open.vertices();
  Outlook outlook;
  outlook.log_scale = conformal_log_scale(open, rough, outlook.turning, run_);
  outlook.stretch = stretch_of_scale(open, outlook.log_scale);
  outlook.worst = static_cast<Index>(std::ranges::min_element(outlook.log_scale) - outlook.log_scale.begin());
  return outlook;
}

bool Atlas::promises(const Stretch& stretch) const {
  constexpr double margin = 0.95;  // predicted stretch is only approximate
  return stretch.mean <= margin * options_.mean_stretch && stretch.worst <= margin * options_.worst_stretch;
}

// Whether a map that keeps lengths more and angles less may do.
bool Atlas::is_near(const Stretch& stretch) const {
  constexpr double far = 3;
  return most_error_.corner > 0 && !promises(stretch) && stretch.mean <= far * options_.mean_stretch &&
         stretch.worst <= far * options_.worst_stretch;
}

bool Atlas::holds(const Chart& chart) const {
  const Stretch stretch = stretch_of_map(chart.open, chart.map->uv);
  return stretch.mean <= options_.mean_stretch && stretch.worst <= options_.worst_stretch;
}

// The free map, unless the disc's keeps angles better: then what a descent from that one gives, if it does as
// well, or the disc's itself.
std::optional<ChartMap> Atlas::in_one(const OpenMesh& open) const {
  std::optional<ChartMap> map = free_chart(open, {}, options_.residual, {}, run_).map;
  AngleError error;
  if (map) {
    error = angle_error(open, map->uv);
    if (open.vertices() > large || !is_above(error, least_error_of_disc(open))) return map;
  }
  std::optional<ChartMap> disc = disc_chart(open, options_.residual, run_);
  if (!disc) return map;
  const AngleError most = angle_error(open, disc->uv);
  if (map && !is_above(error, most)) return map;
  if (map) map = evened_chart(open, *disc, {}, run_).map;
  if (map && !is_above(angle_error(open, map->uv), most)) return map;
  return disc;
}

// The whole in one chart: where slits alone lead to a free map that keeps angles as the disc's does, with
// them.
Chart Atlas::whole(OpenMesh open) {
  constexpr Index small = 10'000;  // vertices: on larger charts the search takes a minute and more
  Chart chart{std::move(open), {}, 0};
  chart.map = in_one(chart.open);
  if (!chart.map || traits(chart.map->kind).released || chart.open.vertices() > small) return chart;
  auto slitted = with_slits(chart.open, look(chart.open));
  if (!slitted) {
    if (const auto to_cones = without_cones(chart.open)) slitted = with_slits(*to_cones, look(*to_cones));
  }
  const auto error = [](const Chart& of) { return angle_error(of.open, of.map->uv); };
  return slitted && !is_above(error(*slitted), error(chart)) ? std::move(*slitted) : std::move(chart);
}

AngleError Atlas::error() const {
  AngleError sum;
  double area = 0;
  std::size_t triangles = 0;
  for (const Chart& chart : done_) {
    const AngleError own = angle_error(chart.open, chart.map->uv);
    double own_area = 0;
    for (const Triangle& t : chart.open.mesh.triangles) own_area += triangle_area(chart.open.points, t);
    sum.corner += own.corner * static_cast<double>(chart.open.mesh.triangles.size());
    sum.area += own.area * own_area;
    triangles += chart.open.mesh.triangles.size();
    area += own_area;
  }
  return {sum.corner / static_cast<double>(std::max<std::size_t>(1, triangles)),
          area > 0 ? sum.area / area : 0};
}

// Whether lengths were kept at too high a cost of angles: a cut is better then.
bool Atlas::is_bent(const Chart& chart) const {
  constexpr double much = 0.025;  // radians above what no map is below
  const AngleError error = angle_error(chart.open, chart.map->uv);
  return is_above(error, most_error_) || error.corner > least_error_of_disc(chart.open).corner + much;
}

// Small shares of a surface get few steps, or none: where many charts are needed, cuts are quicker.
std::int64_t Atlas::work_for(const OpenMesh& open) const {
  constexpr double most_steps = 100, full_share = 1.0 / 40;
  const auto own = static_cast<double>(open.mesh.size()), whole = static_cast<double>(triangles_);
  const double steps = most_steps * own / (full_share * whole);
  if (steps >= most_steps) return work_left_;
  return std::min(work_left_, static_cast<std::int64_t>(steps * own));
}

std::optional<Chart> Atlas::mapped(OpenMesh open, const Outlook& outlook) {
  constexpr double isometry = 0.03, more = 0.1;
  constexpr std::int64_t few = 3, most = 30;  // steps between two looks at the stretch, and looks
  Chart chart{std::move(open), {}, outlook.worst};
  const auto take_over = [&](FreeChart made) {
    work_left_ -= made.work;
    chart.map = std::move(made.map);
  };
  take_over(free_chart(chart.open, outlook.turning, options_.residual,
                       {2 * work_for(chart.open) / 3, isometry}, run_));
  if (chart.map && !holds(chart) && promises(outlook.stretch)) {
    Chart other{chart.open, outline_first_chart(chart.open, outlook.turning, options_.residual, run_), 0};
    if (other.map && holds(other) && !is_bent(other)) chart.map = std::move(other.map);
  }
  const std::int64_t round = few * chart.open.mesh.size();
  const std::int64_t least_left = work_left_ - std::min(work_for(chart.open) / 2, most * round);
  bool evened = false;
  while (chart.map && !holds(chart) && work_left_ - round > least_left) {
    const std::int64_t before = work_left_;
    take_over(evened_chart(chart.open, *chart.map, {round, more}, run_));
    if (work_left_ == before) break;
    evened = true;
  }
  if (evened && chart.map && is_bent(chart)) return {};
  if (!chart.map || !holds(chart)) return {};
  chart.worst = most_stretched(chart.open, chart.map->uv);
  return chart;
}

std::optional<Chart> Atlas::with_slits(const OpenMesh& open, Outlook outlook) {
  constexpr double progress = 0.97;  // of the mean or the worst stretch: more is none
  OpenMesh slitted = open;
  if (promises(outlook.stretch)) return mapped(std::move(slitted), outlook);
  for (std::size_t k = 0; k < most_slits && looks_left_ >= open.vertices(); ++k) {
    run_.check_cancel();
    const std::vector<Index> rims = other_rims(slitted, outlook.worst);
    if (rims.empty()) return {};
    std::vector<OpenMesh> parts = open_parts(slitted, std::vector<Index>(slitted.mesh.triangles.size(), 0),
                                             slit(slitted, outlook.worst, rims));
    if (parts.size() != 1) return {};
    slitted = std::move(parts.front());
    Outlook next = look(slitted);
    if (promises(next.stretch)) return mapped(std::move(slitted), next);
    if (!(next.stretch.mean < progress * outlook.stretch.mean) &&
        !(next.stretch.worst < progress * outlook.stretch.worst))
      return {};
    outlook = std::move(next);
  }
  return {};
}

std::optional<OpenMesh> Atlas::without_cones(const OpenMesh& open) {
  constexpr std::size_t most = 40;
  OpenMesh slitted = open;
  for (std::size_t k = 0; k < most; ++k) {
    run_.check_cancel();
    const Index cone = sharpest_cone(slitted);
    if (cone == none) break;
    std::vector<OpenMesh> parts = open_parts(slitted, std::vector<Index>(slitted.mesh.triangles.size(), 0),
                                             slit(slitted, cone, other_rims(slitted, cone)));
    if (parts.size() != 1) return {};
    slitted = std::move(parts.front());
  }
  if (slitted.vertices() == open.vertices()) return {};
  return slitted;
}

bool Atlas::cut(const OpenMesh& open, Index vertex) {
  if (open.mesh.triangles.size() < 2) return false;
  for (OpenMesh& part : halves(open, vertex)) open_.push_back(std::move(part));
  return true;
}

void Atlas::treat(OpenMesh open) {
  if (!is_free_) {
    Chart chart = whole(std::move(open));
    failed_ = failed_ || !chart.map;
    done_.push_back(std::move(chart));
    return;
  }
  const Outlook outlook = look(open);
  if (auto chart = with_slits(open, outlook)) return done_.push_back(std::move(*chart));
  if (is_near(outlook.stretch)) {
    if (auto chart = mapped(open, outlook)) return done_.push_back(std::move(*chart));
  }
  if (const auto slitted = without_cones(open)) {
    if (auto chart = with_slits(*slitted, look(*slitted))) return done_.push_back(std::move(*chart));
  }
  if (cut(open, outlook.worst)) return;
  Chart last{std::move(open), {}, 0};  // a single triangle
  last.map = free_chart(last.open, {}, options_.residual, {}, run_).map;
  failed_ = failed_ || !last.map;
  done_.push_back(std::move(last));
}

void Atlas::take(std::vector<OpenMesh> parts) {
  // Limits over all charts, for slits and for joining; higher on small surfaces.
  constexpr std::int64_t looks_a_vertex = 25, more = 100, small = 20'000;
  constexpr std::int64_t steps = 60, more_work = 2'000'000;
  for (const OpenMesh& part : parts) {
    work_left_ += steps * std::min<std::int64_t>(part.vertices(), small);
    looks_left_ += looks_a_vertex * part.vertices() + more * std::min<std::int64_t>(part.vertices(), small);
  }
  work_left_ += more_work;
  for (OpenMesh& part : parts) open_.push_back(std::move(part));
  while (!open_.empty()) {
    run_.check_cancel();
    OpenMesh open = std::move(open_.back());
    open_.pop_back();
    treat(std::move(open));
  }
}

void Atlas::append(Atlas&& other) {
  for (Chart& chart : other.done_) done_.push_back(std::move(chart));
  failed_ = failed_ || other.failed_;
}

void Atlas::cut_to(std::size_t count) {
  while (done_.size() < count) {
    const auto largest = std::ranges::max_element(
        done_, {}, [](const Chart& chart) { return chart.open.mesh.triangles.size(); });
    if (largest == done_.end() || largest->open.mesh.triangles.size() < 2) return;
    const Chart chart = std::move(*largest);
    done_.erase(largest);
    take(halves(chart.open, chart.worst));
  }
}

namespace {

// Two charts and the length of their seam.
struct Pair {
  double length;
  Index a, b;  // a < b
};

// Of charts numbered per triangle of `whole`, those with the longest seams first.
std::vector<Pair> neighbours_of(const OpenMesh& whole, const std::vector<Index>& chart) {
  std::map<std::pair<Index, Index>, double> lengths;
  for (Index t = 0; t < whole.mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index other = whole.mesh.adjacent[t][c];
      if (other == none || other < t || chart[other] == chart[t]) continue;
      const Triangle& v = whole.mesh.triangles[t];
      lengths[std::minmax(chart[t], chart[other])] +=
          distance(whole.points[v[next(c)]], whole.points[v[previous(c)]]);
    }
  }
  std::vector<Pair> pairs;
  for (const auto& [pair, length] : lengths) pairs.push_back({length, pair.first, pair.second});
  std::ranges::sort(pairs, [](const Pair& x, const Pair& y) {
    return std::tie(y.length, x.a, x.b) < std::tie(x.length, y.a, y.b);
  });
  return pairs;
}

}  // namespace

void Atlas::join(const OpenMesh& whole) {
  constexpr std::size_t largest = 400'000;  // largest number of triangles of two charts that are tried as one
  std::vector<Index> place;                 // in `whole`, of the surface's triangles
  place.assign(static_cast<std::size_t>(*std::ranges::max_element(whole.triangle)) + 1, none);
  for (std::size_t i = 0; i < whole.triangle.size(); ++i) place[whole.triangle[i]] = static_cast<Index>(i);
  std::set<std::pair<Index, Index>> tried;  // by the first triangles of both
  for (bool again = true; again;) {
    again = false;
    std::vector<Index> number;  // of the chart of each triangle of `whole`
    number.assign(whole.mesh.triangles.size(), none);
    for (std::size_t c = 0; c < done_.size(); ++c) {
      for (const Index t : done_[c].open.triangle) number[place[t]] = static_cast<Index>(c);
    }
    std::vector<char> gone(done_.size(), 0), fresh(done_.size(), 0);
    for (const auto& [length, a, b] : neighbours_of(whole, number)) {
      if (gone[a] || gone[b] || fresh[a] || fresh[b]) continue;
      run_.check_cancel();
      std::vector<Index> both;
      for (const Index c : {a, b}) {
        for (const Index t : done_[c].open.triangle) both.push_back(place[t]);
      }
      if (both.size() > largest) continue;
      if (!tried.emplace(done_[a].open.triangle.front(), done_[b].open.triangle.front()).second) continue;
      if (looks_left_ < static_cast<std::int64_t>(both.size())) break;
      std::ranges::sort(both);
      OpenMesh open = open_selection(whole, both);
      if (open.loops.empty()) continue;
      const Outlook outlook = look(open);
      std::optional<Chart> chart = with_slits(open, outlook);
      if (!chart) continue;
      done_[a] = std::move(*chart);
      fresh[a] = gone[b] = 1;
      again = true;
    }
    std::vector<Chart> left;
    for (std::size_t c = 0; c < done_.size(); ++c) {
      if (!gone[c]) left.push_back(std::move(done_[c]));
    }
    done_ = std::move(left);
  }
}

}  // namespace rimline
