// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/smooth_curve/projections.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

#include "base/model.h"
#include "base/parallel.h"
#include "base/vec.h"

namespace rimline {
namespace {

constexpr std::size_t samples_in_task = 128;  // long enough to hide the cost of a task [speed]
constexpr double infinite = std::numeric_limits<double>::infinity();

// Numbers points in the order of their first use. An open hash table.
class PointNumbers {
 public:
  explicit PointNumbers(std::size_t most_asked)
      : shift_(32 - std::bit_width(most_asked)),               // [layout]
        slots_(std::size_t{1} << (32 - shift_), {none, 0}) {}  // [layout]

  std::uint32_t of(Index point) {
    std::size_t at = static_cast<std::uint32_t>(point) * 2654435769u >> shift_;  // [layout] golden ratio
    while (slots_[at].point != point && slots_[at].point != none) at = next_in(at, slots_.size());
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

// Projects points to the knots near the samples that name them.
class Projector {
 public:
  Projector(const RimCurve& curve, Points points, const Neighbours& neighbours)
      : curve_(curve), points_(points), neighbours_(neighbours) {}

  // The points of a section of the rim and their neighbours.
  std::vector<Projection> project(std::span<const RimSample> samples) const {
    const std::size_t in_list = 1 + static_cast<std::size_t>(neighbours_.k);
    PointNumbers numbers(samples.size() * in_list);
    std::vector<std::uint32_t> asked;  // the number of each sample and of its neighbours, sample after sample
    asked.reserve(samples.size() * in_list);
    std::vector<Projection> found;
    const auto ask = [&](Index point) {
      asked.push_back(numbers.of(point));
      if (asked.back() == found.size()) found.push_back({point});
    };
    for (const RimSample& sample : samples) {
      ask(sample.point);
      found[asked.back()].is_sample = true;
      for (const Index v : neighbours_.of(sample.point)) ask(v);
    }
    std::vector<std::uint32_t> start(found.size() + 2, 0);  // of each projection, in `about`
    for (const std::uint32_t number : asked) ++start[number + 2];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<double> about(asked.size());  // the t of each sample that a point is a neighbour of
    for (std::size_t i = 0; i < asked.size(); ++i) about[start[asked[i] + 1]++] = samples[i / in_list].t;
    for (std::size_t i = 0; i < found.size(); ++i)
      seek(found[i], std::span(about).subspan(start[i], start[i + 1] - start[i]));
    return found;
  }

 private:
  // Seeks the nearest knot about each t, of those whose surface the point lies on.
  void seek(Projection& projection, std::span<const double> about) const {
    constexpr std::ptrdiff_t reach = 8;  // knots, four spacings [speed]
    const std::ptrdiff_t far = std::min(reach, curve_.size() / 3);
    std::ptrdiff_t begin = 0,
                   end = 0;  // range of knots already evaluated: most samples of a projection share it
    for (const double t : about) {
      const std::ptrdiff_t middle = std::lround(t / curve_.period() * static_cast<double>(curve_.size()));
      const std::ptrdiff_t from = middle - far, to = middle + far + 1;
      if (from > end || to < begin) begin = end = from;  // elsewhere
      seek(projection, from, std::min(to, begin));
      seek(projection, std::max(from, end), to);
      begin = std::min(begin, from);
      end = std::max(end, to);
    }
  }
  void seek(Projection& projection, std::ptrdiff_t begin, std::ptrdiff_t end) const {
    for (std::ptrdiff_t k = begin; k < end; ++k) {
      const std::size_t i = curve_.wrap(k);
      const Knot& knot = curve_.knot(i);
      const Point d = points_[projection.point] - knot.at;
      const double squared = dot(d, d);
      if (squared >= projection.squared_distance || std::abs(dot(d, knot.normal)) > knot.spacing) continue;
      projection.squared_distance = squared;
      projection.t = curve_.t_of(i) + std::clamp(dot(d, knot.along) / knot.step, -0.5, 0.5);
      projection.out = dot(d, knot.out) / knot.spacing;
      projection.normal = knot.normal;
      projection.knot = i;
    }
  }

  const RimCurve& curve_;
  Points points_;
  const Neighbours& neighbours_;
};

// Of the projections of a point found by several sections the nearest; ties by the first.
std::vector<Projection> merge(const std::vector<std::vector<Projection>>& parts) {
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  PointNumbers numbers(total);
  std::vector<Projection> merged;
  merged.reserve(total);
  for (const auto& part : parts) {
    for (const Projection& projection : part) {
      const std::uint32_t number = numbers.of(projection.point);
      if (number == merged.size()) {
        merged.push_back(projection);
        continue;
      }
      Projection& known = merged[number];
      const bool is_sample = known.is_sample || projection.is_sample;
      if (projection.squared_distance < known.squared_distance) known = projection;
      known.is_sample = is_sample;
    }
  }
  return merged;
}

}  // namespace

std::vector<Projection> project(const RimCurve& curve, Points points, const Neighbours& neighbours,
                                const std::vector<RimSample>& samples, const Run& run) {
  const Projector projector(curve, points, neighbours);
  std::vector<std::vector<Projection>> parts((samples.size() + samples_in_task - 1) / samples_in_task);
  parallel_tasks(parts.size(), Stage::Loops, run, [&](std::size_t k) {
    const std::size_t first = k * samples_in_task;
    parts[k] = projector.project(
        std::span(samples).subspan(first, std::min(samples_in_task, samples.size() - first)));
  });
  run.check_cancel();
  std::vector<Projection> found = merge(parts);
  std::erase_if(found, [](const Projection& p) { return p.squared_distance == infinite; });
  for (Projection& p : found) p.t -= curve.period() * std::floor(p.t / curve.period());
  return found;
}

std::vector<std::pair<double, Offset>> offsets_behind(const RimCurve& curve,
                                                      const std::vector<Projection>& projections,
                                                      Points points, const Neighbours& neighbours) {
  constexpr double near = model::behind_near, far = model::behind_far;
  constexpr int count = model::more_neighbours;
  std::vector<const Projection*> behind;
  for (const Projection& p : projections) {
    if (p.out <= -near && p.out >= -far) behind.push_back(&p);
  }
  std::sort(behind.begin(), behind.end(), [](const Projection* a, const Projection* b) {
    return std::tie(a->t, a->point) < std::tie(b->t, b->point);
  });
  std::vector<std::pair<double, Offset>> offsets;
  for (const Projection* p : behind) {
    const Knot& knot = curve.knot(p->knot);
    for (const Index v : neighbours.of(p->point, std::min(count, neighbours.k))) {
      const Point d = (1 / knot.spacing) * (points[v] - points[p->point]);
      if (std::abs(dot(d, knot.normal)) < 1)
        offsets.push_back({p->t, {dot(d, knot.along), dot(d, knot.out)}});
    }
  }
  return offsets;
}

std::vector<Projection> from_outermost(std::vector<Projection> projections, const Run& run) {
  Arena(run).execute([&] {
    tbb::parallel_sort(projections.begin(), projections.end(), [](const Projection& a, const Projection& b) {
      return std::tie(b.out, a.point) < std::tie(a.out, b.point);
    });
  });
  return projections;
}

std::vector<RimSample> along_curve(const std::vector<Projection>& projections, std::size_t count) {
  std::vector<RimSample> samples;
  for (std::size_t i = 0; i < count; ++i)
    samples.push_back({projections[i].t, projections[i].point, projections[i].normal});
  std::sort(samples.begin(), samples.end(), [](const RimSample& a, const RimSample& b) {
    return std::tie(a.t, a.point) < std::tie(b.t, b.point);
  });
  return samples;
}

}  // namespace rimline
