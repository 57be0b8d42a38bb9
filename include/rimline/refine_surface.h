// SPDX-License-Identifier: GPL-3.0-or-later
// From loops to the mesh and its map: parameterize, triangulate, flip in space, map again on the mesh.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/neighbours.h"
#include "rimline/options.h"
#include "rimline/points.h"
#include "rimline/report.h"
#include "rimline/run.h"

namespace rimline {

struct RefineOptions {
  Domain domain = Domain::Disc;
  bool map_later = false;  // leave the maps to map_by_charts(): uv is NaN, the mesh is as with a map
  std::array<Index, 4> corners{none, none, none, none};  // of square and rectangle, ids of points of the
                                                         // outer loop; none: found where it turns most
  int rounds = 4;               // upper bound of the rounds of triangulating the map anew [ours]
  double residual = 1e-10;      // of each linear system, relative to its right-hand side
  double suspect_share = 0.05;  // share of bad edges above which a patch is reported as suspect [ours]
  bool leave_beside = false;  // leave out points that lie in no triangle of the surface and beside it: those
                              // of a range scanner at depth jumps [ours]
  HandlePolicy handles = HandlePolicy::Repair;
  HolePolicy holes;          // which holes are closed by triangles
  bool fill_points = false;  // whether these get new vertices
};

// A hole that was closed, or that could not be closed.
struct HoleFill {
  std::vector<Index> rim;     // in the order of its loop
  std::size_t triangles = 0;  // 0 where every triangulation would repeat an existing edge
  std::size_t added_points = 0;
};

// Result of one round.
struct RefineRound {
  std::size_t flips = 0;      // edges flipped in space
  std::size_t bad_edges = 0;  // inner edges left that are longer than 3 spacings or folded beyond 120 degrees
  double length = 0;          // of all inner edges left, in the unit of the input
};

// A patch: one outer loop, any number of holes, all points inside.
struct Patch {
  std::vector<Triangle> triangles;  // its boundary edges are those of the loops that were not filled
  std::vector<UV> uv;               // one per point, then one per added vertex
  std::vector<HoleFill> fills;      // their triangles are the last ones, fill after fill
  std::vector<Point> added;         // vertices of the fills; their ids follow those of the points
  std::vector<RefineRound> rounds;
  Domain domain = Domain::Disc;  // where uv lies: the disc, scaled to the surface's area, where no free map
                                 // without flips was found, the disc's having some itself; None: uv is NaN
  MapSummary map;                // the last system
  std::size_t uv_flips = 0;      // triangles not counter-clockwise in uv: 0 but for maps that double
                                 // precision can not hold
  std::size_t evened = 0;        // points whose weights were equalized to avoid flips
};

// Meshes the disc with holes that the loops bound: the first is the outer one, the others holes, the surface
// on the left of each; they must be disjoint. All points must belong to it. Throws UnreachableInterior,
// NotADisc, NoConvergence, Cancelled.
Patch refine_patch(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                   const RefineOptions& options, const Run& run);

// One component of a surface, or why it could not be meshed.
struct PatchReport {
  std::size_t points = 0, triangles = 0, loops = 0;
  bool orientable = true;
  int genus = 0;  // handles; of a one-sided component the number of cross-caps
  std::vector<HandleRepair> repairs;
  std::vector<RefineRound> rounds;
  Domain domain = Domain::Disc;  // domain of the map; None where there is no map
  MapSummary map;
  std::size_t uv_flips = 0, evened = 0;
  double bad_share = 0;  // of the inner edges: longer than 3 spacings or folded beyond 120 degrees
  bool suspect = false;  // bad_share exceeds RefineOptions::suspect_share: the patch folds over itself, or a
                         // loop is wrong
  std::vector<HoleFill> fills;
  std::string failure;     // empty where it was meshed
  std::vector<Index> ids;  // its points, where it was not
};

// Any number of components of any topology, meshed one by one: a manifold.
struct Surface {
  std::vector<Triangle> triangles;    // patch after patch
  std::vector<Index> triangle_patch;  // of each triangle
  std::vector<char> filled;           // per triangle, 1 where it closes a hole
  std::vector<Point> added;           // vertices of such triangles; their ids follow those of the points
  std::vector<UV> uv;  // one per point and added one; NaN for those of no patch. Patches lie side by side
  std::vector<Index> patch;  // of each of these, or `none`
  std::vector<PatchReport> patches;
  std::vector<Loop> loops;      // the boundary of the mesh, with filled holes; Loop::component is the patch
  std::vector<Index> left_out;  // points in no triangle, ascending
};

// Finds the points and loops of each component and meshes it: discs with holes with their map, any other
// component (closed, with handles, one-sided) as the manifold that its triangles make, without a map. Loops
// that touch each other or themselves are separated, so that Surface::loops may differ from `loops` there. A
// component that can not be meshed has a failure. Throws BadOption for corners that are not on one outer
// loop. `surface_triangles` are triangles that the loops bound (BoundaryLoops::triangles, gaps included);
// where they are empty, the triangles that the points' Voronoi cells agree on are used.
Surface refine_surface(Points points, const Neighbours& neighbours, const std::vector<Loop>& loops,
                       const std::vector<Triangle>& surface_triangles, const RefineOptions& options,
                       const Run& run);

}  // namespace rimline
