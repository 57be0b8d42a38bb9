// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/mesh_part.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "mesh/manifold.h"
#include "patch/mend_surface.h"
#include "patch/refine_patch.h"
#include "patch/repair.h"

namespace rimline {
namespace {

// A subset of the points with neighbours among themselves.
struct Local {
  std::vector<Point> points;
  std::vector<double> spacing;          // of the whole: a small part may have none of its own
  std::optional<Neighbours> own_lists;  // none where the part is the whole
  RefineOptions options;                // with corners in ids of the part

  const Neighbours& neighbours(const Whole& whole) const { return own_lists ? *own_lists : whole.neighbours; }
};

// The options with given corners in ids of the part; without them where they are of another.
RefineOptions options_for(const std::vector<Index>& ids, const RefineOptions& options) {
  RefineOptions own = options;
  std::size_t found = 0;
  for (Index& corner : own.corners) {
    const auto at = std::ranges::lower_bound(ids, corner);
    if (at == ids.end() || *at != corner) continue;
    corner = static_cast<Index>(at - ids.begin());
    ++found;
  }
  if (found == 0) own.corners.fill(none);
  if (found > 0 && found < own.corners.size()) {
    throw Error(ErrorCode::BadOption, "the corners are not on one outer loop",
                {options.corners.begin(), options.corners.end()});
  }
  return own;
}

Local local_of(const Whole& whole, const std::vector<Index>& ids, const RefineOptions& options,
               const Run& run) {
  Local local;
  for (const Index i : ids) {
    local.points.push_back(whole.points[i]);
    local.spacing.push_back(whole.spacing[i]);
  }
  if (ids.size() < whole.points.size())
    local.own_lists = find_neighbours(local.points, whole.neighbours.k, run);
  local.options = options_for(ids, options);
  return local;
}

// Whether the patch is a mesh whose boundary edges are those of the loops that were not filled.
bool is_sound(const Patch& patch, std::size_t points, std::vector<Loop> loops, bool orientable,
              const Run& run) {
  for (const HoleFill& fill : patch.fills) {
    const auto is_rim = [&](const Loop& loop) { return std::ranges::is_permutation(loop.points, fill.rim); };
    if (fill.triangles > 0) std::erase_if(loops, is_rim);
  }
  return fault_of(patch.triangles, points + patch.added.size(), loops, orientable, run).empty();
}

bool is_suspect(const Patch& patch, const RefineOptions& options) {
  return patch.rounds.empty() ||
         static_cast<double>(patch.rounds.back().bad_edges) >
             options.suspect_share * 1.5 * static_cast<double>(patch.triangles.size());
}

// None where the part is no disc with holes, or where its map gives no valid mesh.
std::optional<Component> mesh_as_disc(const Whole& whole, const Local& local, const PatchInput& part,
                                      std::optional<Triangulation> first, const Run& run) {
  Component component{part.points, part.outline.loops, {}, true, 0, {}, ""};
  try {
    component.patch = refine_patch(local.points, local.neighbours(whole), nullptr, component.loops,
                                   std::move(first), local.options, run);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled || error.code() == ErrorCode::OutOfMemory ||
        error.code() == ErrorCode::BadOption)
      throw;
    return {};
  }
  if (!is_sound(component.patch, local.points.size(), component.loops, true, run)) return {};
  return component;
}

std::size_t bad_edges(const Component& component) {
  return component.patch.rounds.empty() ? 0 : component.patch.rounds.back().bad_edges;
}

// Whether the disc represents the surface as well as the mended triangles. Over a true handle, and over a
// one-sided strip, a disc is folded: it has more bad edges for each than noise causes. A mended handle counts
// like one that is there, because the disc keeps the triangles that the repair removed.
bool is_better(const Component& disc, const std::vector<Component>& components) {
  constexpr std::size_t by_noise = 8;  // bad edges for each half of a handle
  if (components.empty()) return true;
  std::size_t allowed = 0, largest = 0, points = 0;
  for (const Component& c : components) {
    const std::size_t halves = static_cast<std::size_t>(c.orientable ? 2 * c.genus : c.genus);
    allowed += bad_edges(c) + by_noise * (halves + 2 * c.repairs.size());
    points += c.points.size();
    largest = std::max(largest, c.points.size());
  }
  return bad_edges(disc) <=
         allowed + (points - largest);  // points of pieces that gaps separate from the largest
}

// Whether the triangles make one disc with as many loops.
bool is_disc_of(const std::vector<MendedPart>& mended, std::size_t loops) {
  return mended.size() == 1 && mended[0].orientable && mended[0].genus == 0 &&
         mended[0].loops.size() == loops;
}

// Whether handles are so many that no disc over them is better: such a cloud is no surface, and a disc's
// mesh and map of it take several times as long as all else.
bool is_hopeless(const std::vector<MendedPart>& mended, std::size_t points) {
  constexpr std::size_t points_a_handle = 200, few = 8;
  std::size_t handles = 0;
  for (const MendedPart& part : mended)
    handles += static_cast<std::size_t>(part.orientable ? part.genus : part.genus / 2);
  return handles > few && handles > points / points_a_handle;
}

// A mended component alone, in ids of the whole.
struct Alone {
  Component component;
  std::vector<Triangle> triangles;
};

Alone take_alone(const PatchInput& part, const MendedPart& mended) {
  Alone alone;
  std::vector<Index> used;
  for (const Triangle& t : mended.triangles) used.insert(used.end(), t.begin(), t.end());
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto own = [&](Index v) {
    return static_cast<Index>(std::ranges::lower_bound(used, v) - used.begin());
  };
  for (const Triangle& t : mended.triangles) alone.triangles.push_back({own(t[0]), own(t[1]), own(t[2])});
  alone.component.loops = mended.loops;
  for (Loop& loop : alone.component.loops) {
    for (Index& v : loop.points) v = own(v);
  }
  for (const Index v : used) alone.component.points.push_back(part.points[v]);
  alone.component.orientable = mended.orientable;
  alone.component.genus = mended.genus;
  alone.component.repairs = mended.repairs;  // in ids of the whole
  for (HandleRepair& repair : alone.component.repairs) {
    for (Index& v : repair.points) v = part.points[v];
  }
  return alone;
}

Component mesh_mended(const Whole& whole, const PatchInput& part, const MendedPart& mended,
                      const RefineOptions& options, const Run& run) {
  auto [component, triangles] = take_alone(part, mended);
  const Local local = local_of(whole, component.points, options, run);
  if (mended.orientable && mended.genus == 0 && !component.loops.empty()) {
    PatchInput disc{component.points, {component.loops, {}}, false};
    auto first = triangulation_of(triangles, static_cast<Index>(local.points.size()));
    if (auto meshed = mesh_as_disc(whole, local, disc, std::move(first), run)) {
      meshed->repairs = std::move(component.repairs);
      return std::move(*meshed);
    }
  }
  component.patch = finish_patch(local.points, local.neighbours(whole), component.loops, std::move(triangles),
                                 component.orientable, local.options, run);
  if (!is_sound(component.patch, local.points.size(), component.loops, component.orientable, run)) {
    component.failure = "no manifold mesh of its triangles was found";
    component.patch = {};
  }
  return component;
}

std::vector<Component> mesh_any(const Whole& whole, const PatchInput& part, const PartTriangles& survey,
                                const RefineOptions& options, const Run& run) {
  const Local local = local_of(whole, part.points, options, run);
  const std::vector<Loop>& loops = part.outline.loops;
  const bool simple = !part.touches && !loops.empty();
  if (simple && survey.end_at_loops) {
    auto first = mesh_of_survey(local.points, local.neighbours(whole), loops, survey.triangles);
    if (first) {
      if (auto disc = mesh_as_disc(whole, local, part, std::move(first), run)) return {std::move(*disc)};
    }
  }
  const std::vector<MendedPart> mended = mend_surface(
      {local.points, local.neighbours(whole), local.spacing, survey.triangles, loops}, options.handles, run);
  const bool same = is_disc_of(mended, loops.size());
  std::optional<Component> disc;
  if (simple && !(survey.end_at_loops && is_hopeless(mended, part.points.size())))
    disc = mesh_as_disc(whole, local, part, {}, run);
  const bool stands = !survey.end_at_loops || (same && disc && !is_suspect(disc->patch, local.options));
  if (disc && stands) return {std::move(*disc)};
  std::vector<Component> components;
  for (const MendedPart& own : mended) components.push_back(mesh_mended(whole, part, own, options, run));
  if (disc && is_better(*disc, components)) return {std::move(*disc)};
  return components;
}

}  // namespace

std::vector<Component> mesh_part(const Whole& whole, const PatchInput& part, const PartTriangles& survey,
                                 const RefineOptions& options, const Run& run) {
  Arena arena(run);  // limits the parallel work below to the run's threads
  return arena.execute([&] { return mesh_any(whole, part, survey, options, run); });
}

}  // namespace rimline
