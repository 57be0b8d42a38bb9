// SPDX-License-Identifier: GPL-3.0-or-later
// The k-nearest loop that a user of a library writes: build the tree, ask for each point in turn.
#ifdef RIMLINE_HAVE_NANOFLANN

#include <benchmark/benchmark.h>

#include <nanoflann.hpp>
#include <vector>

#include "clouds.h"

namespace rimline::bench {
namespace {

struct Adaptor {
  Points points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    const Point& p = points[i];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>, Adaptor, 3, Index>;

// On one thread: compare with the CPU time of find_neighbours.
void nanoflann_loop(benchmark::State& state, const std::vector<Point>& points) {
  constexpr int k = 41;  // the point itself comes first
  for (auto _ : state) {
    const Adaptor adaptor{points};
    const Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(16));
    std::vector<Index> ids(k * points.size());
    std::vector<double> squared(k * points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double query[3] = {points[i].x, points[i].y, points[i].z};
      tree.knnSearch(query, k, ids.data() + k * i, squared.data() + k * i);
    }
    benchmark::DoNotOptimize(ids.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

void nanoflann_in_input_order(benchmark::State& state) {
  nanoflann_loop(state, sheet(static_cast<int>(state.range(0))));
}
void nanoflann_in_morton_order(benchmark::State& state) {
  nanoflann_loop(state, arranged_sheet(static_cast<int>(state.range(0))));
}

void sizes(benchmark::internal::Benchmark* b) {
  b->RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
  b->MeasureProcessCPUTime();
}

BENCHMARK(nanoflann_in_input_order)->Apply(sizes);
BENCHMARK(nanoflann_in_morton_order)->Apply(sizes);

}  // namespace
}  // namespace rimline::bench

#endif
