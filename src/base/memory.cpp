// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/domain_traits.h"

namespace rimline {
namespace {

// Bytes per point, measured at a million points and rounded up by a tenth (docs/memory.md).
constexpr double arrange_bytes = 80;
constexpr double neighbours_bytes = 130;
constexpr double boundary_bytes = 100;
constexpr double survey_bytes = 440;       // frames, stars, triangles
constexpr double loops_bytes = 440;        // the same, and the search
constexpr double paper_loops_bytes = 150;  // closed paths and chromosomes need little
constexpr double refine_bytes = 780;       // mesh, system, multigrid
constexpr double measure_bytes = 650;
constexpr double solve_bytes = 500, solve_neighbour_bytes = 95;  // of eq. (4), and of its solver's vectors
constexpr double triangulate_bytes = 680;
constexpr double factor_bytes = 230;  // of the system of a free map and its factor, times log2 of the points
constexpr double fixed_bytes = 16e6;  // the program itself is 10e6
constexpr double neighbour_bytes = sizeof(Index);

// Memory of a stage, besides fixed_bytes.
struct StageBytes {
  Stage stage;
  UsedBy used_by;  // the presets that run it
  double per_point;
  bool has_lists = true;  // the lists of neighbours are held, too
};

std::string gigabytes(double bytes) { return fmt::format("{:.3g} GB", bytes / 1e9); }

}  // namespace

std::vector<StageMemory> estimate_memory(std::size_t points, const Options& options) {
  const double n = static_cast<double>(points);
  const double solve = solve_bytes + solve_neighbour_bytes * options.map.map_k;
  const double factor = traits(options.map.domain).released ? factor_bytes * std::log2(n + 2) : 0;
  const StageBytes all[] = {{Stage::Arrange, UsedBy::All, arrange_bytes, false},
                            {Stage::Neighbours, UsedBy::All, neighbours_bytes},
                            {Stage::Boundary, UsedBy::All, boundary_bytes},
                            {Stage::Survey, UsedBy::Default, survey_bytes},
                            {Stage::Loops, UsedBy::Default, loops_bytes},
                            {Stage::Loops, UsedBy::Paper, paper_loops_bytes},
                            {Stage::Parameterize, UsedBy::Paper, solve},
                            {Stage::Triangulate, UsedBy::Paper, triangulate_bytes},
                            {Stage::Refine, UsedBy::Default, refine_bytes + factor},
                            {Stage::Measure, UsedBy::All, measure_bytes}};
  const double lists = neighbour_bytes * most_neighbours(options);
  std::vector<StageMemory> stages;
  for (const StageBytes& stage : all) {
    if (!counts(stage.used_by, options)) continue;
    const double per_point = stage.per_point + (stage.has_lists ? lists : 0);
    stages.push_back({stage.stage, static_cast<std::size_t>(fixed_bytes + n * per_point)});
  }
  return stages;
}

void check_memory(std::size_t points, const Options& options, Stage last, const Run& run) {
  if (run.memory_limit == 0) return;
  std::vector<StageMemory> stages = estimate_memory(points, options);
  std::erase_if(stages, [&](const StageMemory& s) { return s.stage > last; });
  if (stages.empty()) return;
  const StageMemory& most =
      *std::max_element(stages.begin(), stages.end(),
                        [](const StageMemory& a, const StageMemory& b) { return a.bytes < b.bytes; });
  if (most.bytes <= run.memory_limit) return;
  throw Error(
      ErrorCode::OutOfMemory,
      fmt::format("{} points need about {} (at the stage {}), the limit is {}; raise the limit or thin "
                  "the cloud",
                  points, gigabytes(static_cast<double>(most.bytes)), name(most.stage),
                  gigabytes(static_cast<double>(run.memory_limit))));
}

}  // namespace rimline
