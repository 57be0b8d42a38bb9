// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rim_curve.h"

#include <oneapi/tbb/parallel_sort.h>
#include <oneapi/tbb/task_arena.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

#include "exact/odds.h"
#include "exact/weave.h"
#include "parallel.h"

namespace rimline::exact {
namespace {

// Long enough to hide the cost of a task.
constexpr std::size_t stations_in_task = 32, beads_in_task = 128;

constexpr double infinite = std::numeric_limits<double>::infinity();

// A point of the rim.
struct Bead {
  double t;  // along the rim, in [0, period): about one a point
  Index point;
  Point normal;
};

// A place on the curve.
struct Station {
  Point at, along, out, normal;  // the directions are unit vectors
  double step;                   // length of one unit of t
  double spacing;                // of the points here
  double along_weave = 1;        // how much closer points lie along the curve than alike in all directions,
  double out_weave = 1;          // and across it
};

Point unit(Point p) { return (1 / std::max(norm(p), 1e-300)) * p; }

class Curve {
 public:
  Curve(Points points, const Neighbours& neighbours, const std::vector<double>& spacing, bool woven,
        const Run& run)
      : points_(points), neighbours_(neighbours), spacing_(spacing), woven_(woven), run_(run) {}

  // Fits the beads, which ascend by t, by quadratics in t over `window` units to either side. False where
  // they are too few.
  bool fit(const std::vector<Bead>& beads, double period, double window) {
    period_ = period;
    bead_spacing_.clear();
    for (const Bead& bead : beads) bead_spacing_.push_back(spacing_around(bead.point));
    stations_.assign(static_cast<std::size_t>(std::lround(2 * period)), {});
    std::atomic<bool> enough = true;
    parallel_slices(
        stations_.size(), Stage::Loops, run_,
        [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            if (!fit_at(beads, t_of(i), std::min(window, period / 4), stations_[i])) enough = false;
          }
        },
        stations_in_task);
    return enough;
  }

  double period() const { return period_; }
  std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(stations_.size()); }
  // For numbers that are once around off at most.
  std::size_t wrap(std::ptrdiff_t i) const {
    return static_cast<std::size_t>(i < 0 ? i + size() : i < size() ? i : i - size());
  }
  const Station& station(std::size_t i) const { return stations_[i]; }
  double t_of(std::size_t i) const { return period_ * static_cast<double>(i) / static_cast<double>(size()); }

  // How many points a rim here has where points are one to a square spacing.
  double point_count() const {
    double sum = 0;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const Station &a = stations_[i], &b = stations_[i + 1 < stations_.size() ? i + 1 : 0];
      sum += a.along_weave * distance(a.at, b.at) / (0.5 * (a.spacing + b.spacing));
    }
    return sum;
  }

  // The same from the first station to each, and once around.
  std::vector<double> running_count() const {
    std::vector<double> running{0};
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const Station &a = stations_[i], &b = stations_[i + 1 < stations_.size() ? i + 1 : 0];
      running.push_back(running.back() +
                        a.along_weave * distance(a.at, b.at) / (0.5 * (a.spacing + b.spacing)));
    }
    return running;
  }

  // Whether points lie closer in one direction than in another.
  bool woven() const { return woven_; }

  // Measures in which directions points lie close, where they do, from those behind the rim: places t,
  // ascending, and offsets along the curve and out to neighbours, in spacings.
  void set_weaves(const std::vector<std::pair<double, Offset>>& offsets) {
    constexpr double window = 6;       // of t, to either side
    constexpr std::size_t stride = 6;  // from one measure to the next; between them it changes little
    const auto take = [&](double from, double to, std::vector<Offset>& near) {
      auto at = std::lower_bound(offsets.begin(), offsets.end(), from,
                                 [](const auto& x, double t) { return x.first < t; });
      for (; at != offsets.end() && at->first < to; ++at) near.push_back(at->second);
    };
    const double reach = std::min(window, period_ / 2);
    std::vector<Weave> weaves((stations_.size() - 1) / stride + 1);
    parallel_tasks(weaves.size(), Stage::Loops, run_, [&](std::size_t m) {
      std::vector<Offset> near;
      for (const double turn : {-period_, 0.0, period_}) {
        take(t_of(m * stride) + turn - reach, t_of(m * stride) + turn + reach, near);
      }
      weaves[m] = find_weave(near);
    });
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      stations_[i].along_weave = std::sqrt(weaves[i / stride].xx);
      stations_[i].out_weave = std::sqrt(weaves[i / stride].yy);
    }
  }

  // Area in square spacings of a strip one spacing wide, as the weave has it, `depth` spacings inwards.
  double strip(double depth) const {
    double sum = 0;
    const auto moved = [&](const Station& s) { return s.at - depth * s.spacing * s.out; };
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const Station &a = stations_[i], &b = stations_[i + 1 < stations_.size() ? i + 1 : 0];
      sum += distance(moved(a), moved(b)) / (0.5 * (a.spacing + b.spacing)) / a.out_weave;
    }
    return sum;
  }

 private:
  bool fit_at(const std::vector<Bead>& beads, double t, double window, Station& station) const {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
    Point normal;
    double spacing = 0, sum = 0;
    int count = 0;
    const auto take = [&](std::size_t i) {
      const Bead& bead = beads[i];
      const double dt = std::remainder(bead.t - t, period_), far = std::abs(dt) / window;
      if (far >= 1) return false;
      const double weight = std::pow(1 - far * far * far, 3);
      const Eigen::Vector3d row(1, dt, dt * dt);
      const Point p = points_[bead.point] - points_[beads.front().point];
      squares += weight * row * row.transpose();
      right += weight * row * Eigen::RowVector3d(p.x, p.y, p.z);
      normal = normal + weight * bead.normal;
      spacing += weight * bead_spacing_[i];
      sum += weight;
      ++count;
      return true;
    };
    const auto n = static_cast<std::ptrdiff_t>(beads.size());
    const auto around = [&](std::ptrdiff_t k) {
      return static_cast<std::size_t>(k < 0 ? k + n : k < n ? k : k - n);
    };
    const auto first = std::lower_bound(beads.begin(), beads.end(), t,
                                        [](const Bead& bead, double at) { return bead.t < at; }) -
                       beads.begin();
    for (std::ptrdiff_t k = first; k < first + n && take(around(k));) ++k;
    for (std::ptrdiff_t k = first - 1; k > first - n && take(around(k));) --k;
    if (count < 4) return false;
    const Eigen::Matrix3d fit = squares.ldlt().solve(right);
    const Point along{fit(1, 0), fit(1, 1), fit(1, 2)};
    station.at = points_[beads.front().point] + Point{fit(0, 0), fit(0, 1), fit(0, 2)};
    station.step = std::max(norm(along), 1e-300);
    station.along = unit(along);
    station.normal = unit(normal);
    station.out = unit(cross(along, normal));
    station.spacing = spacing / sum;
    return true;
  }

  // Less partial than the spacing of a point of the rim, whose neighbours are on one side.
  double spacing_around(Index point) const {
    const auto near = neighbours_.of(point, std::min(12, neighbours_.k));
    double sum = 0;
    for (const Index v : near) sum += spacing_[v];
    return sum / static_cast<double>(near.size());
  }

  Points points_;
  const Neighbours& neighbours_;
  const std::vector<double>& spacing_;
  bool woven_;
  const Run& run_;
  std::vector<Station> stations_;
  std::vector<double> bead_spacing_;  // around each of the beads
  double period_ = 0;
};

// Where a point lies over the curve.
struct Place {
  Index point = none;
  double t = 0, out = 0;  // out: in spacings, as the weave has them
  std::size_t station = 0;
  double squared_distance = infinite;
  Point normal = {};
  bool is_bead = false;
};

// Numbers points in the order in which they are asked for first. An open hash table.
class PlaceNumbers {
 public:
  explicit PlaceNumbers(std::size_t most_asked)
      : shift_(32 - std::bit_width(most_asked)), slots_(std::size_t{1} << (32 - shift_), {none, 0}) {}

  std::uint32_t of(Index point) {
    std::size_t at = static_cast<std::uint32_t>(point) * 2654435769u >> shift_;
    while (slots_[at].point != point && slots_[at].point != none) at = at + 1 < slots_.size() ? at + 1 : 0;
    if (slots_[at].point == none) slots_[at] = {point, count_++};
    return slots_[at].number;
  }

 private:
  struct Slot {
    Index point;
    std::uint32_t number;
  };

  int shift_;
  std::vector<Slot> slots_;
  std::uint32_t count_ = 0;
};

// The points around the beads, from the outermost inwards.
class Places {
 public:
  Places(Curve& curve, Points points, const Neighbours& neighbours, const std::vector<Bead>& beads,
         const Run& run)
      : curve_(curve), points_(points) {
    look_around(beads, neighbours, run);
    std::erase_if(found_, [](const Place& p) { return p.squared_distance == infinite; });
    for (Place& p : found_) p.t -= curve.period() * std::floor(p.t / curve.period());
    if (curve.woven()) {
      curve.set_weaves(offsets_behind(neighbours));
      for (Place& p : found_) p.out *= station_of(p).out_weave;
    }
    tbb::task_arena(thread_count(run)).execute([&] {
      tbb::parallel_sort(found_.begin(), found_.end(), [](const Place& a, const Place& b) {
        return std::tie(b.out, a.point) < std::tie(a.out, b.point);
      });
    });
  }

  const std::vector<Place>& found() const { return found_; }

  // How many lie farther out.
  std::size_t beyond(double out) const {
    const auto at = std::lower_bound(found_.begin(), found_.end(), out,
                                     [](const Place& p, double x) { return p.out > x; });
    return static_cast<std::size_t>(at - found_.begin());
  }

  // Of the ways to part them near the first `count` the one where they are fewest.
  std::size_t valley(std::size_t count) const {
    constexpr double width = 0.12;                      // spacings: half of what is looked at
    const double usual = 2 * width * curve_.strip(0);   // one point to a square spacing
    const double share = curve_.woven() ? 0.08 : 0.03;  // by which the count is wrong
    const double likely = 1 + share * static_cast<double>(count);
    const auto most = static_cast<std::size_t>(std::lround(2 * likely));
    double least = infinite;
    std::size_t best = count;
    for (std::size_t k = count - std::min(most, count - 1); k <= count + most && k < found_.size(); ++k) {
      const double at = 0.5 * (found_[k - 1].out + found_[k].out);
      const auto crowd = static_cast<double>(beyond(at - width) - beyond(at + width));
      const double off = (static_cast<double>(k) - static_cast<double>(count)) / likely;
      const double cost = crowd / usual + 0.5 * off * off;
      if (cost < least) {
        least = cost;
        best = k;
      }
    }
    return best;
  }

 private:
  // Finds the places of the beads and of their neighbours: of stretches of beads side by side, then of the
  // places that several stretches have found the nearest, or first.
  void look_around(std::span<const Bead> beads, const Neighbours& neighbours, const Run& run) {
    std::vector<std::vector<Place>> parts((beads.size() + beads_in_task - 1) / beads_in_task);
    parallel_tasks(parts.size(), Stage::Loops, run, [&](std::size_t k) {
      const std::size_t first = k * beads_in_task;
      parts[k] = look_around(beads.subspan(first, std::min(beads_in_task, beads.size() - first)), neighbours);
    });
    run.check_cancel();
    std::size_t total = 0;
    for (const auto& part : parts) total += part.size();
    PlaceNumbers numbers(total);
    found_.reserve(total);
    for (const auto& part : parts) {
      for (const Place& place : part) {
        const std::uint32_t number = numbers.of(place.point);
        if (number == found_.size()) {
          found_.push_back(place);
          continue;
        }
        Place& known = found_[number];
        const bool is_bead = known.is_bead || place.is_bead;
        if (place.squared_distance < known.squared_distance) known = place;
        known.is_bead = is_bead;
      }
    }
  }

  std::vector<Place> look_around(std::span<const Bead> beads, const Neighbours& neighbours) const {
    const std::size_t in_list = 1 + static_cast<std::size_t>(neighbours.k);
    PlaceNumbers numbers(beads.size() * in_list);
    std::vector<std::uint32_t> asked;  // the place of each bead and of its neighbours, bead after bead
    asked.reserve(beads.size() * in_list);
    std::vector<Place> places;
    const auto ask = [&](Index point) {
      asked.push_back(numbers.of(point));
      if (asked.back() == places.size()) places.push_back({point});
    };
    for (const Bead& bead : beads) {
      ask(bead.point);
      places[asked.back()].is_bead = true;
      for (const Index v : neighbours.of(bead.point)) ask(v);
    }
    std::vector<std::uint32_t> start(places.size() + 2, 0);  // of the places, in `about`
    for (const std::uint32_t place : asked) ++start[place + 2];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<double> about(asked.size());  // the t of each bead that a place is a neighbour of
    for (std::size_t i = 0; i < asked.size(); ++i) about[start[asked[i] + 1]++] = beads[i / in_list].t;
    for (std::size_t i = 0; i < places.size(); ++i)
      look(places[i], std::span(about).subspan(start[i], start[i + 1] - start[i]));
    return places;
  }

  // Seeks the nearest station about each t, in the sheet of the curve.
  void look(Place& place, std::span<const double> about) const {
    constexpr std::ptrdiff_t reach = 8;  // stations, four spacings
    const std::ptrdiff_t far = std::min(reach, curve_.size() / 3);
    std::ptrdiff_t begin = 0, end = 0;  // stations that were looked at: most beads of a place share them
    for (const double t : about) {
      const std::ptrdiff_t middle = std::lround(t / curve_.period() * static_cast<double>(curve_.size()));
      const std::ptrdiff_t from = middle - far, to = middle + far + 1;
      if (from > end || to < begin) begin = end = from;  // elsewhere
      look(place, from, std::min(to, begin));
      look(place, std::max(from, end), to);
      begin = std::min(begin, from);
      end = std::max(end, to);
    }
  }
  void look(Place& place, std::ptrdiff_t begin, std::ptrdiff_t end) const {
    for (std::ptrdiff_t k = begin; k < end; ++k) {
      const std::size_t i = curve_.wrap(k);
      const Station& s = curve_.station(i);
      const Point d = points_[place.point] - s.at;
      const double squared = dot(d, d);
      if (squared >= place.squared_distance || std::abs(dot(d, s.normal)) > s.spacing) continue;
      place.squared_distance = squared;
      place.t = curve_.t_of(i) + std::clamp(dot(d, s.along) / s.step, -0.5, 0.5);
      place.out = dot(d, s.out) / s.spacing;
      place.normal = s.normal;
      place.station = i;
    }
  }

  const Station& station_of(const Place& place) const { return curve_.station(place.station); }

  // From the places right behind the rim, along it, to their neighbours.
  std::vector<std::pair<double, Offset>> offsets_behind(const Neighbours& neighbours) const {
    constexpr double near = 0.6, far = 2.6;  // spacings
    constexpr int count = 16;
    std::vector<const Place*> behind;
    for (const Place& place : found_) {
      if (place.out <= -near && place.out >= -far) behind.push_back(&place);
    }
    std::sort(behind.begin(), behind.end(), [](const Place* a, const Place* b) {
      return std::tie(a->t, a->point) < std::tie(b->t, b->point);
    });
    std::vector<std::pair<double, Offset>> offsets;
    for (const Place* place : behind) {
      const Station& s = station_of(*place);
      for (const Index v : neighbours.of(place->point, std::min(count, neighbours.k))) {
        const Point d = (1 / s.spacing) * (points_[v] - points_[place->point]);
        if (std::abs(dot(d, s.normal)) < 1) offsets.push_back({place->t, {dot(d, s.along), dot(d, s.out)}});
      }
    }
    return offsets;
  }

  const Curve& curve_;
  Points points_;
  std::vector<Place> found_;
};

// Median place of the beads across the curve.
double row_of(const Places& places) {
  std::vector<double> out;
  for (const Place& p : places.found()) {
    if (p.is_bead) out.push_back(p.out);
  }
  return out.empty() ? 0 : out[out.size() / 2];  // the places descend
}

// How many points the rim has.
std::size_t expected_count(const Curve& curve, const Places& places, double row) {
  // The density is measured in a strip behind the rim with soft edges, so that rows do not come in or fall
  // out.
  constexpr double middle = 1.5, width = 1;  // spacings
  double behind = 0;
  for (const Place& p : places.found()) behind += std::max(0.0, 1 - std::abs(p.out - row + middle) / width);
  const double density = behind / (width * curve.strip(middle - row));
  const double count = std::sqrt(density) * curve.point_count() * curve.strip(-row) / curve.strip(0);
  return count < 1e9 ? static_cast<std::size_t>(std::lround(count)) : 0;  // 0 where there is no area behind
}

// How many points are so close behind a rim of `count` points that nothing tells them from it: of random ones
// half a spacing's worth.
std::size_t beside(std::size_t count, const Blur& blur) {
  return static_cast<std::size_t>(std::lround(0.5 * blur.irregular * static_cast<double>(count)));
}

// What parts the first `last` places, which may be on the rim, from the others. Where points are strewn at
// random without noise, half of the first `count` lie farther out than the rim's own line, so half a spacing
// is measured from there: to count what lies in it is wrong by as much as chance has put there.
double parting_line(const std::vector<Place>& places, std::size_t count, std::size_t last, const Blur& blur) {
  if (last > count && blur.noise == 0 && blur.irregular >= 0.5) return places[count / 2].out - 0.5;
  return 0.5 * (places[last - 1].out + places[last].out);
}

// The first `count` places, along the curve.
std::vector<Bead> outermost(const std::vector<Place>& places, std::size_t count) {
  std::vector<Bead> beads;
  for (std::size_t i = 0; i < count; ++i) beads.push_back({places[i].t, places[i].point, places[i].normal});
  std::sort(beads.begin(), beads.end(),
            [](const Bead& a, const Bead& b) { return std::tie(a.t, a.point) < std::tie(b.t, b.point); });
  return beads;
}

// A place that the rim may go through.
struct Stop {
  double at;    // along the curve, in mean steps of the rim
  double odds;  // logarithm, by how far out it lies
  std::size_t place;
  double best = -infinite;  // of all ways to here
  std::size_t before = 0;   // the stop before on that way
};

// The stops from the outermost place once around and back to it, of places that descend. `line`: what parts
// the first `count` of them from the others.
std::vector<Stop> find_stops(const Curve& curve, const std::vector<Place>& places, std::size_t count,
                             double line, double noise) {
  constexpr double least_odds = -6;  // of a place that is worth a look
  const std::vector<double> along = curve.running_count();
  const auto around = static_cast<double>(count);
  const auto position = [&](double t) {
    const double x = std::clamp(t / curve.period(), 0.0, 1.0) * static_cast<double>(along.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(x), along.size() - 2);
    const double here = along[i] + (x - static_cast<double>(i)) * (along[i + 1] - along[i]);
    return around * here / along.back();
  };
  const double start = position(places[0].t);
  std::vector<Stop> stops;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double odds = blurred_log_odds(places[i].out - line, noise);
    if (odds < least_odds) break;
    const double at = position(places[i].t) - start;
    stops.push_back({at < 0 ? at + around : at, odds, i});
  }
  std::sort(stops.begin(), stops.end(),
            [](const Stop& a, const Stop& b) { return std::tie(a.at, a.place) < std::tie(b.at, b.place); });
  stops.insert(stops.begin(), {0, 0, 0, 0});
  stops.push_back({around, 0, 0});
  return stops;
}

// Noise moves points along the rim as well as across it. So where two of the outermost lie close together one
// of them is likely to come from behind, and where they leave a gap the outermost point of the gap is likely
// to be of the rim. Of all ways around the curve this is the likeliest: it has the greatest sum of the log
// odds of its points by how far out they lie, less what its steps cost by how far their lengths are from 1,
// as normal errors of that variance do. By dynamic programming.
std::vector<Bead> likeliest_way(const Curve& curve, const std::vector<Place>& places, std::size_t count,
                                double noise) {
  constexpr double uneven = 0.1;        // variance of the steps of a rim without noise: 0.3 of their length
  constexpr double usual = 0.4;         // about the mean cost of a step, so that it moves no line
  constexpr std::size_t farthest = 48;  // stops passed over
  const double variance = uneven + 2 * noise * noise;  // both ends of a step move
  const double line = 0.5 * (places[count - 1].out + places[count].out);
  std::vector<Stop> stops = find_stops(curve, places, count, line, noise);
  for (std::size_t j = 1; j < stops.size(); ++j) {
    for (std::size_t i = j - std::min(j, farthest); i < j; ++i) {
      const double off = stops[j].at - stops[i].at - 1;
      const double sum = stops[i].best + stops[j].odds + usual - off * off / (2 * variance);
      if (sum <= stops[j].best) continue;
      stops[j].best = sum;
      stops[j].before = i;
    }
  }
  std::vector<Place> way;
  for (std::size_t j = stops.back().before;; j = stops[j].before) {
    way.push_back(places[stops[j].place]);
    if (j == 0) break;
  }
  return outermost(way, way.size());
}

// Turns stretches of the loop round where that makes it shorter, as seen along the normals: then it does not
// cross itself there.
void shorten(Points points, std::vector<Bead>& loop) {
  constexpr std::size_t longest = 8;
  constexpr int sweeps = 10;
  const std::size_t n = loop.size();
  if (n < 3 * longest) return;
  const auto at = [&](std::size_t i) -> Bead& { return loop[i % n]; };
  const auto length = [&](std::size_t i, std::size_t j, Point normal) {
    const Point d = points[at(j).point] - points[at(i).point];
    return norm(d - dot(d, normal) * normal);
  };
  bool again = true;
  for (int sweep = 0; sweep < sweeps && again; ++sweep) {
    again = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < i + longest; ++j) {  // the stretch from i + 1 to j
        const Point normal = at(i).normal;
        const double before = length(i, i + 1, normal) + length(j, j + 1, normal);
        if (length(i, j, normal) + length(i + 1, j + 1, normal) >= before * (1 - 1e-9)) continue;
        for (std::size_t a = i + 1, b = j; a < b; ++a, --b) std::swap(at(a), at(b));
        again = true;
      }
    }
  }
}

}  // namespace

Redrawn redraw(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
               const std::vector<Index>& rim, const std::vector<Point>& normals, const Blur& blur,
               const Run& run) {
  constexpr std::size_t shortest = 10;
  constexpr int rounds = 3;  // each fits the curve to the loop of the last
  if (rim.size() < shortest) return {};
  const double window = 4 + 8 * blur.noise;  // the curve must average over more where points scatter more
  std::vector<Bead> beads, on_rim;
  for (std::size_t i = 0; i < rim.size(); ++i) beads.push_back({static_cast<double>(i), rim[i], normals[i]});
  Curve curve(points, neighbours, spacing, blur.woven, run);
  Redrawn result;
  for (int round = 0; round < rounds; ++round) {
    if (!curve.fit(beads, static_cast<double>(rim.size()), window)) return {};
    const Places places(curve, points, neighbours, beads, run);
    std::size_t count = expected_count(curve, places, row_of(places));
    if (count < shortest || count >= places.found().size()) return {};
    const std::size_t close = curve.woven() ? 0 : beside(count, blur);  // rows are not strewn
    // What is behind a rim with more points than that does not tell its points.
    if (count + close < rim.size()) return {};
    count = places.valley(count);
    const auto& all = places.found();
    const std::size_t last = std::min(all.size() - 1, count + close);
    if (round + 1 < rounds) {
      beads = outermost(all, last);
      continue;
    }
    const bool even = blur.noise > 0 && blur.irregular < 0.5 && !curve.woven();
    on_rim = even ? likeliest_way(curve, all, count, blur.noise) : outermost(all, count);
    const double line = parting_line(all, count, last, blur);
    for (const Place& p : all) {
      result.near.push_back(p.point);
      result.depth.push_back(p.out - line);
    }
  }
  if (on_rim.size() < shortest) return {};
  shorten(points, on_rim);
  for (const Bead& bead : on_rim) result.loop.push_back(bead.point);
  return result;
}

}  // namespace rimline::exact
