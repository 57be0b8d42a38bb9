// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/refine_surface.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "patch/join_components.h"
#include "patch/mesh_part.h"
#include "patch/outliers.h"
#include "patch/pack.h"
#include "patch/partition.h"
#include "patch/share_out.h"
#include "patch/topology.h"

namespace rimline {
namespace {

// Checks the corners: those in no part would otherwise be ignored.
void check_corners(const std::vector<PatchInput>& parts, const RefineOptions& options) {
  if (options.corners[0] == none) return;
  for (const PatchInput& part : parts) {
    for (const Index corner : options.corners) {
      if (std::ranges::binary_search(part.points, corner)) return;
    }
  }
  throw Error(ErrorCode::BadOption, "the corners are on no loop",
              {options.corners.begin(), options.corners.end()});
}

// The result of one part, or the error that it threw.
struct Meshed {
  std::vector<Component> components;
  std::exception_ptr failure;
};

// Calls mesh(p, run) for every part. Large parts use all threads, one part after the other; small parts use
// one thread each.
template <class Mesh>
std::vector<Meshed> mesh_all(const std::vector<PatchInput>& parts, const Mesh& mesh, const Run& run) {
  constexpr std::size_t large = 20'000, batch = 64;  // points; parts between two looks at progress
  std::vector<Meshed> meshed(parts.size());
  const auto keep = [&](std::size_t p, const Run& own_run) {
    try {
      meshed[p].components = mesh(p, own_run);
    } catch (...) {
      meshed[p].failure = std::current_exception();
    }
  };
  std::vector<std::size_t> small;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    run.check_cancel();
    if (parts.size() == 1 || parts[p].points.size() >= large) {
      keep(p, run);
    } else {
      small.push_back(p);
    }
  }
  Run alone = run.without_progress();  // progress is reported by the calling thread
  alone.threads = 1;
  Arena arena(run);
  for (std::size_t first = 0; first < small.size(); first += batch) {
    run.progress(Stage::Refine, first, small.size());
    arena.execute([&] {
      const std::size_t count = std::min(batch, small.size() - first);
      run_tasks(count, [&](std::size_t i) { keep(small[first + i], alone); });
    });
  }
  run.check_cancel();
  return meshed;
}

// Merges parts that share points, or whose loops visit a point twice: they touch in points alone, and their
// triangles tell which component has the point.
void pool_touching(const std::vector<Loop>& loops, std::size_t points, std::vector<PatchInput>& parts) {
  std::vector<int> count(points, 0);
  for (const PatchInput& part : parts) {
    for (const Index v : part.points) ++count[v];
  }
  const auto touches = [&](const PatchInput& part) {
    return !part.outline.original.empty() ||
           std::ranges::any_of(part.points, [&](Index v) { return count[v] > 1; });
  };
  PatchInput pool;
  for (const PatchInput& part : parts) {
    if (touches(part)) pool.points.insert(pool.points.end(), part.points.begin(), part.points.end());
  }
  if (pool.points.empty()) return;
  std::erase_if(parts, touches);
  std::ranges::sort(pool.points);
  pool.points.erase(std::unique(pool.points.begin(), pool.points.end()), pool.points.end());
  for (Loop loop : loops) {
    if (!std::ranges::binary_search(pool.points, loop.points.front())) continue;
    for (Index& v : loop.points)
      v = static_cast<Index>(std::ranges::lower_bound(pool.points, v) - pool.points.begin());
    pool.outline.loops.push_back(std::move(loop));
  }
  pool.touches = true;
  parts.push_back(std::move(pool));
}

// Points in triangles that are connected to no loop: closed surfaces, and remains of open ones.
PatchInput without_loops(const std::vector<Index>& left_out, const std::vector<Triangle>& triangles,
                         std::size_t points) {
  std::vector<char> loose(points, 0), used(points, 0);
  for (const Index v : left_out) loose[v] = 1;
  for (const Triangle& t : triangles) {
    if (loose[t[0]] && loose[t[1]] && loose[t[2]]) used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  PatchInput part;
  for (const Index v : left_out) {
    if (used[v]) part.points.push_back(v);
  }
  return part;
}

// The given loops in their order, with their properties, then new ones.
std::vector<Loop> in_order_of(const std::vector<Loop>& given, std::vector<Loop> loops) {
  std::map<std::vector<Index>, std::size_t> place;  // by the points; the first of equal ones
  const auto key = [](std::vector<Index> points) {
    std::ranges::sort(points);
    return points;
  };
  for (std::size_t l = 0; l < given.size(); ++l) place.emplace(key(given[l].points), l);
  const auto rank = [&](const Loop& loop) {
    const auto at = place.find(key(loop.points));
    return at == place.end() ? given.size() : at->second;
  };
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t l = 0; l < loops.size(); ++l) order.emplace_back(rank(loops[l]), l);
  std::ranges::sort(order);
  std::vector<Loop> sorted;
  for (const auto& [at, l] : order) {
    Loop& loop = sorted.emplace_back(std::move(loops[l]));
    if (at == given.size()) continue;
    loop.kind = given[at].kind;
    loop.length = given[at].length;
    loop.fitness = given[at].fitness;
    loop.probability = given[at].probability;
  }
  return sorted;
}

// The result of a part that ended in an error.
std::vector<Component> failed(const PatchInput& part, const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled || error.code() == ErrorCode::OutOfMemory ||
        error.code() == ErrorCode::BadOption)
      throw;
    Component component{part.points, {}, {}, true, 0, {}, error.what()};
    return {std::move(component)};
  }
}

}  // namespace

Surface refine_surface(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                       const std::vector<Triangle>& surface_triangles, const RefineOptions& options,
                       const Run& run) {
  std::optional<Stars> stars;
  const auto find = [&]() -> const Stars& {
    if (!stars) stars = find_weighted_stars(points, neighbours, run);
    return *stars;
  };
  Partition whole = partition(static_cast<Index>(points.size()), find, loops, surface_triangles);
  if (options.leave_beside)
    whole = without_points(std::move(whole), points_beside(points, neighbours, loops, surface_triangles));
  std::vector<PatchInput>& parts = whole.patches;
  check_corners(parts, options);
  const std::vector<Triangle> agreed =
      surface_triangles.empty() ? agreed_triangles(find()) : std::vector<Triangle>{};
  const std::vector<Triangle>& triangles = surface_triangles.empty() ? agreed : surface_triangles;
  pool_touching(loops, points.size(), parts);
  // Loops without triangles are given, and define the surface.
  if (!surface_triangles.empty() || loops.empty())
    parts.push_back(without_loops(whole.left_out, triangles, points.size()));
  if (!parts.empty() && parts.back().points.empty()) parts.pop_back();
  const std::vector<std::vector<Triangle>> surveys = share_out(triangles, points.size(), parts);
  const std::vector<double> spacing = local_spacing(points, neighbours, run);
  const auto mesh = [&](std::size_t p, const Run& own_run) {
    const PartTriangles own{surveys[p], !surface_triangles.empty()};
    return mesh_part({points, neighbours, spacing}, parts[p], own, options, own_run);
  };
  std::vector<Meshed> meshed = mesh_all(parts, mesh, run);
  std::vector<Component> components;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (meshed[p].failure) meshed[p].components = failed(parts[p], meshed[p].failure);
    std::ranges::move(meshed[p].components, std::back_inserter(components));
  }
  Surface surface = join_components(points.size(), std::move(components), options);
  surface.loops = in_order_of(loops, std::move(surface.loops));
  return surface;
}

}  // namespace rimline
