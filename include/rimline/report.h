// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a run: counts, measures, costs and warnings.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/options.h"
#include "rimline/run.h"

namespace rimline {

// Points of the input, and the reasons why some were not used.
struct PointCounts {
  std::size_t input = 0;
  std::size_t used = 0;        // input less those below
  std::size_t not_finite = 0;  // a coordinate is NaN or infinite
  std::size_t duplicates = 0;  // the same coordinates as a point with a lower id
  std::size_t stray = 0;       // in a group of fewer than ten points, separate from all others
  std::size_t unmeshed =
      0;  // used, but in no triangle: in a component that was not meshed or is too small, or off the surface
};

// Distances between neighbours, in the unit of the input: over all used points, of local_spacing().
struct SpacingSummary {
  double mean = 0, least = 0, most = 0;
  double low = 0, high = 0;  // the 5 % and 95 % quantiles
};

// Coordinates in steps, as rounding, depth cameras and regular grids make them: the length of a step in the
// unit of the input, 0 where the coordinate is not in steps.
struct StepSummary {
  double x = 0, y = 0, z = 0;
  double removed = 0;         // of the terraces that were smoothed before anything else was asked
  std::string removed_along;  // "x", "y", "z" or "ray"; empty where there were none
};

// The paper's assumptions, measured.
struct AssumptionSummary {
  double delta = 0;              // Assumption 2.4: the least lambda_2 / (lambda_1 + lambda_2 + lambda_3)
  std::size_t below_delta = 0;   // points whose share is below 0.05  [ours]: nearly on a line
  double points_per_sector = 0;  // k / r; section 2.3 wants at least 5
  bool chi_square_valid = true;  // points_per_sector >= 5
};

// One generation of Algorithm 3.2. Fitness after eq. (3).
struct Generation {
  double best = 0, mean = 0;
};

// The source of the loop in the paper's presets.
enum class LoopSource {
  Fittest,      // the best chromosome of all generations
  Later,        // a less fit one, since the loops of better ones did not close
  InitialPath,  // a path of Algorithm 3.1, since no chromosome's did
};

// "fittest chromosome", "later chromosome", "initial path".
const char* name(LoopSource source);

// Algorithms 3.1 and 3.2.
struct SearchSummary {
  std::size_t starts = 0;          // candidates from which a path was sought
  std::size_t closed_paths = 0;    // starts that found one
  std::size_t distinct_paths = 0;  // after duplicates were dropped
  std::size_t population = 0;      // of these the ones that are generation 0
  std::int64_t steps = 0;          // neighbours visited
  bool bound_hit = false;          // max_path_steps ended the search before every candidate was a start
  LoopSource loop_from = LoopSource::Fittest;
  std::size_t winner_points = 0;  // bits set in the winning chromosome
  double winner_fitness = 0;      // its e(C) of eq. (3); that of the loop's own points is Loop::fitness
  std::size_t winner_rank = 0;    // number of fitter chromosomes, or initial paths, whose loop did not close
  std::vector<Generation> history;  // generation 0 is the initial population
  std::size_t doubtful = 0;         // preset `default`: candidate triangles, the bits of the chromosomes
  std::size_t groups = 0;           // groups of candidates that do not influence each other
  double greedy_fitness = 0;        // fitness of deciding each triangle by its own size
};

// The linear system of eq. (4).
struct MapSummary {
  std::size_t unknowns = 0;
  int iterations = 0;   // 0 for a direct solve
  double residual = 0;  // relative, the larger of u and v
};

// Measures of the mesh, from its triangles alone.
struct MeshSummary {
  std::size_t triangles = 0;
  std::size_t points_used = 0;  // vertices of at least one triangle
  long long euler = 0;          // V - E + F over used vertices
  std::size_t components = 0;
  std::size_t boundary_loops = 0;
  std::size_t boundary_edges = 0;
  std::size_t nonmanifold_edges = 0;                  // with more than two triangles
  std::size_t nonmanifold_vertices = 0;               // whose triangles form more than one fan
  std::array<std::size_t, 12> min_angle_histogram{};  // triangles by least angle, in slices of 5 degrees
  double area = 0;
  std::size_t edges = 0;
  std::size_t long_edges = 0;        // inner edges longer than 3 spacings (the larger of their ends')
  std::size_t uv_flips = 0;          // triangles not counter-clockwise in uv
  double mean_angle_distortion = 0;  // mean absolute difference of a corner's angle in 3D and in uv, radians
};

// A gap between triangles that was taken for no boundary, but may be one.
struct DoubtfulGap {
  std::size_t points = 0;  // on its rim
  double length = 0;       // of its rim, in the unit of the input
  double probability = 0;  // to be a boundary
  Point place;             // mean of its points
};

// Distortion of angles, areas and lengths by the map. The map is scaled to the area of the surface before
// areas and lengths are compared; means are weighted by the triangles' area in space.
struct DistortionSummary {
  double angle_mean = 0, angle_most = 0;    // difference of a corner's angle in space and in uv, radians;
                                            // mean over a triangle's corners
  double area_least = 0, area_most = 0;     // a triangle's area in uv over that in space
  double area_mean_log = 0;                 // mean |ln| of that ratio: 0 where areas are kept
  double stretch_l2 = 0, stretch_linf = 0;  // Sander, Snyder, Gortler, Hoppe 2001, eqs. for L2(M), Linf(M):
                                            // 1 at best
};

// A hole that was closed.
struct FilledHole {
  std::size_t points = 0;  // on its rim
  double length = 0;       // of its rim, in the unit of the input
  std::size_t triangles = 0, added_points = 0;
};

// Counts of holes.
struct HoleSummary {
  std::size_t found = 0, kept = 0;  // holes that are kept are loops of the mesh's boundary
  std::size_t failed = 0;           // of those kept: every triangulation would repeat an existing edge
  std::vector<FilledHole> filled;
};

// Distances from positions on one surface to the nearest point of another, in the unit of the input. The
// positions are the vertices, the midpoints of edges and the centroids of triangles.
struct DistanceSummary {
  double mean = 0, rms = 0, most = 0;
};

// Comparison of the mesh with a reference.
struct ReferenceSummary {
  std::string name;  // name given by the caller
  std::size_t points = 0, triangles = 0;
  double area = 0;
  DistanceSummary to_reference, from_reference;
  double hausdorff = 0;               // the larger of the two greatest distances
  std::optional<double> edges_agree;  // F1 of the two sets of edges; where the vertices are the same
};

// A handle that was removed as noise, and its repair.
struct HandleRepair {
  std::vector<Index> points;  // of the short closed curve along which the handle was cut, in order
  Point place;                // their mean
  double length = 0;          // of the curve, in the unit of the input
  std::size_t removed = 0;    // triangles
  std::size_t added = 0;      // triangles
};

// A component of the surface, as the loops bound it.
struct ComponentSummary {
  std::size_t points = 0, triangles = 0, loops = 0;
  Domain map = Domain::None;  // domain of its map
  std::size_t charts = 0;     // of its map
  double seams = 0;           // length of the edges that its charts are cut along, in the unit of the input
  bool orientable = true;
  int genus = 0;  // handles; of a one-sided component the number of cross-caps
  std::vector<HandleRepair> repairs;
  Point low, high;            // the box of its points
  std::size_t bad_edges = 0;  // inner edges longer than 3 spacings or folded beyond 120 degrees
  double bad_share = 0;       // of the inner edges
  bool suspect = false;  // bad_share is so large that the component folds over itself, or a loop is wrong
  std::string failure;   // the reason why it could not be meshed; empty where it was
  MeshSummary mesh;      // where it was
  DistortionSummary distortion;
  std::size_t self_intersections = 0;           // pairs with a triangle of this component
  std::optional<DistanceSummary> to_reference;  // where there is one
};

// A connected group of points in no triangle.
struct LeftOut {
  Index component = none;  // the component that could not be meshed, or none
  std::vector<Index> ids;  // ascending
  Point low, high;         // their box
  std::string cause, remedy;
};

// Cost of a stage.
struct StageCost {
  Stage stage = Stage::Read;
  double seconds = 0;
  std::size_t peak_bytes = 0;  // resident memory at its highest while the stage ran
};

struct Report {
  Options options;
  std::uint64_t seed = 1;
  PointCounts points;
  SpacingSummary spacing;
  StepSummary steps;
  AssumptionSummary assumptions;
  std::size_t candidates = 0;
  std::size_t undersampled = 0;  // candidates on no loop: the paper's map of undersampled regions
  std::vector<Loop> loops;
  std::vector<DoubtfulGap> doubtful;  // preset `default`, the likeliest first
  bool closed = false;  // preset `default`: there are no loops, and most points lie on closed surfaces
  SearchSummary search;
  bool has_map = false;
  MapSummary map;
  bool has_mesh = false;
  MeshSummary mesh;
  DistortionSummary distortion;
  std::size_t self_intersections =
      0;  // pairs of triangles that meet in more than a vertex or edge they share
  bool more_self_intersections = false;  // counting stopped at this number
  std::optional<HoleSummary> holes;      // preset `default`
  std::optional<ReferenceSummary> reference;
  std::vector<ComponentSummary> components;  // preset `default`, of the mesh
  std::vector<LeftOut> left_out;             // preset `default`, the largest first
  double longest_edge = 0;                   // of the mesh, over the median spacing
  Point offset;                       // subtracted from all coordinates in the mesh's file: zero, but for STL
  std::vector<std::string> warnings;  // one sentence each, for people

  int threads = 0;
  std::vector<StageCost> stages;
};

// REPORT.json, docs/formats.md. All that may differ between two runs of the same input, options and seed
// is in its object "run".
std::string to_json(const Report& report);

}  // namespace rimline
