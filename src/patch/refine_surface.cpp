// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/refine_surface.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "base/union_find.h"
#include "patch/outliers.h"
#include "patch/pack.h"
#include "patch/partition.h"
#include "patch/refine_patch.h"
#include "patch/share_out.h"

namespace rimline {
namespace {

Patch refine_alone(Points points, const PatchInput& input, std::vector<Triangle> survey, int k,
                   const RefineOptions& options, const Run& run) {
  std::vector<Point> own;
  own.reserve(input.points.size());
  for (const Index i : input.points) own.push_back(points[i]);
  const Neighbours neighbours = find_neighbours(own, k, run);
  return refine_patch(own, neighbours, nullptr, input.outline, std::move(survey), options, run);
}

PatchReport report_on(const PatchInput& input, const Patch& patch, const RefineOptions& options) {
  PatchReport report;
  report.points = input.points.size();
  report.triangles = patch.triangles.size();
  report.loops = input.outline.loops.size();
  report.rounds = patch.rounds;
  report.map = patch.map;
  report.uv_flips = patch.uv_flips;
  report.evened = patch.evened;
  report.domain = patch.domain;
  report.fills = patch.fills;
  for (HoleFill& fill : report.fills) {
    for (Index& v : fill.rim) v = input.points[v];
  }
  std::size_t rim = 0, bad = std::numeric_limits<std::size_t>::max();
  for (const Loop& loop : input.outline.loops) rim += loop.points.size();
  for (const RefineRound& round : patch.rounds) bad = std::min(bad, round.bad_edges);
  const double inner = (3.0 * static_cast<double>(patch.triangles.size()) - static_cast<double>(rim)) / 2;
  report.bad_share = inner > 0 ? static_cast<double>(bad) / inner : 0;
  report.suspect = report.bad_share > options.suspect_share;
  return report;
}

// Adds the patch last reported to the whole, in its ids.
void append(const PatchInput& input, const Patch& patch, Surface& surface) {
  const Index at = static_cast<Index>(surface.patches.size()) - 1;
  const auto own = static_cast<Index>(input.points.size());
  const auto first_added = static_cast<Index>(surface.uv.size());
  const auto whole = [&](Index v) { return v < own ? input.points[v] : first_added + (v - own); };
  for (const Triangle& t : patch.triangles) {
    surface.triangles.push_back({whole(t[0]), whole(t[1]), whole(t[2])});
  }
  for (Index i = 0; i < own; ++i) {
    surface.uv[input.points[i]] = patch.uv[i];
    surface.patch[input.points[i]] = at;
  }
  surface.added.insert(surface.added.end(), patch.added.begin(), patch.added.end());
  surface.uv.insert(surface.uv.end(), patch.uv.begin() + own, patch.uv.end());
  surface.patch.insert(surface.patch.end(), patch.added.size(), at);
  surface.triangle_patch.resize(surface.triangles.size(), at);
  std::size_t filled = 0;
  for (const HoleFill& fill : patch.fills) filled += fill.triangles;
  surface.filled.resize(surface.triangles.size() - filled, 0);
  surface.filled.resize(surface.triangles.size(), 1);
}

// The options with given corners in ids of the patch; without them where they are of another.
RefineOptions options_for(const PatchInput& input, const RefineOptions& options) {
  RefineOptions own = options;
  std::size_t found = 0;
  for (Index& corner : own.corners) {
    const auto at = std::lower_bound(input.points.begin(), input.points.end(), corner);
    if (at == input.points.end() || *at != corner) continue;
    corner = static_cast<Index>(at - input.points.begin());
    ++found;
  }
  if (found == 0) own.corners.fill(none);
  if (found > 0 && found < own.corners.size()) {
    throw Error(ErrorCode::BadOption, "the corners are not on one outer loop",
                {options.corners.begin(), options.corners.end()});
  }
  return own;
}

// Corners that lie in no patch would be passed over in silence.
void check_corners(const std::vector<PatchInput>& patches, const RefineOptions& options) {
  if (options.corners[0] == none) return;
  for (const PatchInput& input : patches) {
    if (options_for(input, options).corners[0] != none) return;
  }
  throw Error(ErrorCode::BadOption, "the corners are on no loop",
              {options.corners.begin(), options.corners.end()});
}

// Components that no loop bounds and that are closed. Scraps at a ragged rim are not: of
// a patch of V points and B of them on its rim, which has about 3.5 sqrt(V) or more, the triangles number 2 V
// - B - 2; a closed surface has 2 V. Those of fewer points than `least` tell too little.
std::vector<std::vector<Index>> closed_parts(const std::vector<Index>& left_out, std::size_t points,
                                             const std::vector<Triangle>& surface_triangles) {
  constexpr std::size_t least = 100;
  constexpr double closed = 1.8;  // triangles a point
  std::vector<char> loose(points, 0);
  for (const Index v : left_out) loose[v] = 1;
  UnionFind parts(points);
  std::vector<Index> triangles(points, 0);
  const auto is_loose = [&](const Triangle& t) { return loose[t[0]] && loose[t[1]] && loose[t[2]]; };
  for (const Triangle& t : surface_triangles) {
    if (!is_loose(t)) continue;
    parts.join(t[0], t[1]);
    parts.join(t[1], t[2]);
  }
  for (const Triangle& t : surface_triangles) {
    if (is_loose(t)) ++triangles[parts.find(t[0])];
  }
  std::map<Index, std::vector<Index>> members;  // by part
  for (const Index v : left_out) members[parts.find(v)].push_back(v);
  std::vector<std::vector<Index>> found;
  for (auto& [part, ids] : members) {
    if (ids.size() >= least && triangles[part] >= closed * static_cast<double>(ids.size()))
      found.push_back(std::move(ids));
  }
  return found;
}

// A closed component is refused by name, or reported where the others are to be meshed nonetheless.
void refuse_closed(const std::vector<Triangle>& surface_triangles, std::size_t points, bool allow_partial,
                   Surface& surface) {
  for (std::vector<Index>& ids : closed_parts(surface.left_out, points, surface_triangles)) {
    const std::string message =
        "a component of " + std::to_string(ids.size()) + " points is closed: it has no boundary to end at";
    if (!allow_partial) throw Error(ErrorCode::NotADisc, message, std::move(ids));
    surface.patches.push_back({});
    surface.patches.back().points = ids.size();
    surface.patches.back().failure = message;
  }
}

// Takes the points given, ascending and on no loop, out of the patches.
void leave_out(const std::vector<Index>& points, Partition& parts) {
  for (PatchInput& patch : parts.patches) {
    std::vector<Index> number(patch.points.size(), none), kept;
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
      if (std::binary_search(points.begin(), points.end(), patch.points[i])) continue;
      number[i] = static_cast<Index>(kept.size());
      kept.push_back(patch.points[i]);
    }
    const auto before = static_cast<Index>(patch.points.size());
    const Index gone = before - static_cast<Index>(kept.size());
    for (Loop& loop : patch.outline.loops) {
      for (Index& v : loop.points) v = v < before ? number[v] : v - gone;
    }
    for (Index& v : patch.outline.original) v = number[v];
    patch.points = std::move(kept);
  }
  parts.left_out.insert(parts.left_out.end(), points.begin(), points.end());
  std::sort(parts.left_out.begin(), parts.left_out.end());
  parts.left_out.erase(std::unique(parts.left_out.begin(), parts.left_out.end()), parts.left_out.end());
}

// A patch, or what was thrown instead.
struct Meshed {
  Patch patch;
  std::exception_ptr failure;
};

// Calls mesh(p, run) for every patch. Large ones have all threads to themselves, one after the other; of
// small ones each thread has its own.
template <class Mesh>
std::vector<Meshed> mesh_all(const std::vector<PatchInput>& patches, const Mesh& mesh, const Run& run) {
  constexpr std::size_t large = 20'000, batch = 64;  // points; patches between two looks at progress
  std::vector<Meshed> meshed(patches.size());
  const auto keep = [&](std::size_t p, const Run& own_run) {
    try {
      meshed[p].patch = mesh(p, own_run);
    } catch (...) {
      meshed[p].failure = std::current_exception();
    }
  };
  std::vector<std::size_t> small;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    run.check_cancel();
    if (patches.size() == 1 || patches[p].points.size() >= large) {
      keep(p, run);
    } else {
      small.push_back(p);
    }
  }
  Run alone = run.without_progress();  // which is for the thread that called
  alone.threads = 1;
  tbb::task_arena arena(thread_count(run));
  for (std::size_t first = 0; first < small.size(); first += batch) {
    run.progress(Stage::Refine, first, small.size());
    arena.execute([&] {
      tbb::parallel_for(first, std::min(first + batch, small.size()),
                        [&](std::size_t i) { keep(small[i], alone); });
    });
  }
  run.check_cancel();
  return meshed;
}

Surface mesh_surface(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                     const std::vector<Triangle>& surface_triangles, const RefineOptions& options,
                     const Run& run) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::optional<Stars> stars;
  const auto find = [&]() -> const Stars& {
    if (!stars) stars = find_stars(points, neighbours, {}, {}, run);
    return *stars;
  };
  Partition parts = partition(static_cast<Index>(points.size()), find, loops, surface_triangles);
  if (options.leave_beside) leave_out(points_beside(points, neighbours, loops, surface_triangles), parts);
  Surface surface;
  surface.uv.assign(points.size(), {nan, nan});
  surface.patch.assign(points.size(), none);
  surface.left_out = std::move(parts.left_out);
  std::vector<std::vector<Triangle>> surveys = share_out(surface_triangles, points.size(), parts.patches);
  check_corners(parts.patches, options);
  const auto mesh = [&](std::size_t p, const Run& own_run) {
    const PatchInput& input = parts.patches[p];
    const RefineOptions own = options_for(input, options);
    return input.points.size() == points.size()
               ? refine_patch(points, neighbours, stars ? &*stars : nullptr, input.outline,
                              std::move(surveys[p]), own, own_run)
               : refine_alone(points, input, std::move(surveys[p]), neighbours.k, own, own_run);
  };
  std::vector<Meshed> meshed = mesh_all(parts.patches, mesh, run);
  for (std::size_t p = 0; p < parts.patches.size(); ++p) {
    const PatchInput& input = parts.patches[p];
    try {
      if (meshed[p].failure) std::rethrow_exception(meshed[p].failure);
      surface.patches.push_back(report_on(input, meshed[p].patch, options));
      append(input, meshed[p].patch, surface);
      meshed[p] = {};
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Cancelled || error.code() == ErrorCode::OutOfMemory) throw;
      std::vector<Index> ids;
      for (const Index i : error.ids()) ids.push_back(input.points[i]);
      if (!options.allow_partial || error.code() == ErrorCode::BadOption)
        throw Error(error.code(), error.what(), std::move(ids));
      surface.patches.push_back({});
      surface.patches.back().points = input.points.size();
      surface.patches.back().loops = input.outline.loops.size();
      surface.patches.back().failure = error.what();
    }
  }
  refuse_closed(surface_triangles, points.size(), options.allow_partial, surface);
  pack_patches(surface.patch, surface.patches.size(), surface.uv);
  return surface;
}

}  // namespace

Surface refine_surface(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                       const std::vector<Triangle>& surface_triangles, const RefineOptions& options,
                       const Run& run) {
  if (loops.empty()) throw Error(ErrorCode::NoClosedLoop, "there is no loop: nothing bounds the surface");
  try {
    return mesh_surface(points, neighbours, loops, surface_triangles, options, run);
  } catch (const Error& error) {
    // Without the outliers other points may no longer be connected to the surface.
    if (!options.leave_beside || error.code() != ErrorCode::UnreachableInterior) throw;
  }
  RefineOptions with_all = options;
  with_all.leave_beside = false;
  return mesh_surface(points, neighbours, loops, surface_triangles, with_all, run);
}

}  // namespace rimline
