// SPDX-License-Identifier: GPL-3.0-or-later
// Each stage alone, at the defaults, on one and two threads.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

#include "clouds.h"
#include "rimline/arrange.h"
#include "rimline/boundary_loops.h"
#include "rimline/delaunay.h"
#include "rimline/neighbours.h"
#include "rimline/score_boundary.h"

namespace rimline::bench {
namespace {

constexpr int k = 40;

// The arguments of a benchmark: points, threads.
int size_of(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

Run run_of(const benchmark::State& state) {
  Run run;
  run.threads = static_cast<int>(state.range(1));
  return run;
}

void count_points(benchmark::State& state) { state.SetItemsProcessed(state.iterations() * state.range(0)); }

void arrange_stage(benchmark::State& state) {
  const auto& points = sheet(size_of(state));
  for (auto _ : state) benchmark::DoNotOptimize(arrange(points, run_of(state)).ids.data());
  count_points(state);
}

void neighbours_stage(benchmark::State& state) {
  const auto& points = arranged_sheet(size_of(state));
  for (auto _ : state) benchmark::DoNotOptimize(find_neighbours(points, k, run_of(state)).ids.data());
  count_points(state);
}

void neighbours_stage_in_input_order(benchmark::State& state) {
  const auto& points = sheet(size_of(state));
  for (auto _ : state) benchmark::DoNotOptimize(find_neighbours(points, k, run_of(state)).ids.data());
  count_points(state);
}

void leave_out_stray_stage(benchmark::State& state) {
  Arrangement arrangement = arrange(sheet(size_of(state)), {});
  const Neighbours neighbours = find_neighbours(arrangement.points, k, {});
  for (auto _ : state) benchmark::DoNotOptimize(leave_out_stray(arrangement, neighbours));
  count_points(state);
}

void score_boundary_stage(benchmark::State& state) {
  const auto& points = arranged_sheet(size_of(state));
  const Neighbours neighbours = find_neighbours(points, k, {});
  for (auto _ : state) {
    benchmark::DoNotOptimize(score_boundary(points, neighbours, {}, run_of(state)).log_score.data());
  }
  count_points(state);
}

void delaunay_stage(benchmark::State& state) {
  std::vector<UV> uv;
  for (const Point& p : arranged_sheet(size_of(state))) uv.push_back({p.x, p.y});
  for (auto _ : state) benchmark::DoNotOptimize(delaunay(uv, run_of(state)).data());
  count_points(state);
}

void find_boundary_loops_stage(benchmark::State& state) {
  const auto& points = arranged_sheet(size_of(state));
  const Neighbours neighbours = find_neighbours(points, k, {});
  const BoundaryScores scores = score_boundary(points, neighbours, {}, {});
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        find_boundary_loops(points, neighbours, scores, {}, 0.9, run_of(state)).loops.data());
  }
  count_points(state);
}

// What memory gives: bytes copied. The limit of every stage.
void memory_copy(benchmark::State& state) {
  const std::vector<char> from(static_cast<std::size_t>(state.range(0)), 1);
  std::vector<char> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}

void on_one_thread(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{10'000, 100'000, 1'000'000}, {1}})->ArgNames({"points", "threads"});
  b->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}
void on_threads(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{10'000, 100'000, 1'000'000}, {1, 2}})->ArgNames({"points", "threads"});
  b->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

BENCHMARK(arrange_stage)->Apply(on_threads);
BENCHMARK(neighbours_stage)->Apply(on_threads);
BENCHMARK(neighbours_stage_in_input_order)->Apply(on_threads);
BENCHMARK(leave_out_stray_stage)->Apply(on_one_thread);
BENCHMARK(score_boundary_stage)->Apply(on_threads);
BENCHMARK(find_boundary_loops_stage)->Apply(on_threads);
BENCHMARK(delaunay_stage)->Apply(on_one_thread);
BENCHMARK(memory_copy)->Arg(1 << 28)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace rimline::bench
