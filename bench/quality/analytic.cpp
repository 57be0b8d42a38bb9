// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/analytic.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "base/random.h"
#include "sample/density.h"
#include "sample/surface.h"

namespace rimline::bench {
namespace {

constexpr std::size_t topology_points = 5000;

template <class Value>
Value by_name(const std::vector<Value>& values, const std::string& wanted) {
  return *std::find_if(values.begin(), values.end(), [&](Value v) { return name(v) == wanted; });
}

// FNV-1a, 64 bits: a case has the same seed whichever others run beside it.
std::uint64_t hash(const std::string& text) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const unsigned char c : text) h = (h ^ c) * 0x100000001b3;
  return h;
}

void add_draws(std::vector<CaseName>& cases, CaseName name, const AnalyticPlan& plan) {
  for (name.draw = 0; name.draw < plan.draws; ++name.draw) {
    name.seed = Random(plan.seed, hash(name.text())).next();
    cases.push_back(name);
  }
}

Run run_with(std::uint64_t seed) {
  Run run;
  run.seed = seed;
  run.threads = 1;
  return run;
}

SampleOptions sample_options(const CaseName& name) {
  return {by_name(all_shapes(), name.shape), by_name(all_samplings(), name.sampling), name.n, name.noise};
}

bool is_open(Shape shape) {
  return shape != Shape::ClosedSphere && shape != Shape::TorusMinusCap && shape != Shape::MoebiusStrip;
}

// V - E + F of the surface: 2 - 2 handles - loops, or 1 - crosscaps... of the few that are no disc.
long long euler_number(Shape shape, std::size_t loops) {
  const long long handles = shape == Shape::TorusMinusCap ? 1 : 0;
  const long long crosscaps = shape == Shape::MoebiusStrip ? 1 : 0;
  return 2 - 2 * handles - crosscaps - static_cast<long long>(loops);
}

std::shared_ptr<const TrueSurface> make_true_surface(Shape shape, std::size_t n) {
  auto result = std::make_shared<TrueSurface>();
  const Sample dense = sample({shape, Sampling::BlueNoise, 4 * n, 0}, run_with(1));
  result->points = dense.points;
  result->area = measure(make_surface(shape), {}).area;
  result->loops = dense.loops.size();
  result->euler = euler_number(shape, result->loops);
  return result;
}

}  // namespace

std::vector<CaseName> analytic_cases(const AnalyticPlan& plan) {
  std::vector<CaseName> cases;
  for (const Shape shape : all_shapes()) {
    if (!is_open(shape)) continue;
    for (const Sampling sampling : all_samplings()) {
      for (const std::size_t n : plan.sizes) {
        for (const double noise : plan.noises) {
          add_draws(cases, {"analytic", name(shape), name(sampling), noise, n, 0, 1}, plan);
        }
      }
    }
  }
  return cases;
}

std::vector<CaseName> closed_cases(const AnalyticPlan& plan) {
  std::vector<CaseName> cases;
  for (const double noise : plan.noises) {
    for (const Shape shape : {Shape::ClosedSphere, Shape::TorusMinusCap, Shape::MoebiusStrip})
      add_draws(cases, {"topology", name(shape), name(Sampling::BlueNoise), noise, topology_points, 0, 1},
                plan);
  }
  return cases;
}

std::vector<CaseName> topology_cases(const AnalyticPlan& plan) {
  std::vector<CaseName> cases;
  for (const Shape shape : {Shape::Pipe, Shape::ClosedSphere, Shape::TorusMinusCap, Shape::MoebiusStrip}) {
    add_draws(cases, {"topology", name(shape), name(Sampling::BlueNoise), 0, topology_points, 0, 1}, plan);
  }
  return cases;
}

std::shared_ptr<const TrueSurface> true_surface(const CaseName& name) {
  static std::mutex mutex;
  static std::map<std::pair<std::string, std::size_t>, std::shared_ptr<const TrueSurface>> made;
  const std::lock_guard lock(mutex);
  auto& surface = made[{name.shape, name.n}];
  if (!surface) surface = make_true_surface(by_name(all_shapes(), name.shape), name.n);
  return surface;
}

std::optional<Case> make_analytic(const CaseName& name) try {
  const Sample drawn = sample(sample_options(name), run_with(name.seed));
  Case c;
  c.name = name;
  c.points = drawn.points;
  c.boundary = drawn.near_boundary;
  c.rim = drawn.boundary;
  c.has_loops = true;
  for (const Loop& loop : drawn.loops) c.loops.push_back(edges_of_loop(loop.points));
  measure_spacing(c);
  return c;
} catch (const Error& error) {
  if (error.code() != ErrorCode::BadOption) throw;
  return std::nullopt;
}

}  // namespace rimline::bench
