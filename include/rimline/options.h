// SPDX-License-Identifier: GPL-3.0-or-later
// All options of the method with their defaults. They are written here once; the library, the tool, the
// report and the docs read them from here.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// A named set of defaults.
enum class Preset {
  Default,   // the recommended method
  Paper,     // Maes & Bultheel 2004, step by step, with the approximation of eq. (2) that gives its figures
  PaperLog,  // the same, with the logarithm of eq. (2)
};

// How eq. (2) enters the fitness, eq. (3).
enum class ScoreForm {
  Printed,  // 1 / p: spans nine decades over one straight edge, so one corner can decide
  Capped,   // 1 / max(p, score_cap): an approximation, as section 3.3 says that it used  [docs/departures.md]
  Log,      // -log p  [ours, docs/departures.md]
};

// "default", "paper", "paper-log"; "printed", "capped", "log".
const char* name(Preset preset);
const char* name(ScoreForm form);

// Section 2: which points may lie on the boundary.
struct BoundaryOptions {
  int k = 40;                  // neighbours in the test (section 4)
  int sectors = 8;             // r in eq. (1): equal slices of [0, 2 pi) (section 4); wants k / sectors >= 5
  double significance = 0.10;  // alpha: a point with p <= alpha is a candidate (section 4)
};

// Section 3: from candidates to the boundary.
struct LoopOptions {
  ScoreForm score_form = ScoreForm::Log;
  double score_cap = 1e-3;             // lower bound of p in the score form Capped  [docs/paper.md]
  int path_k = 40;                     // neighbours in Algorithm 3.1 (section 4; the paper's teapot wants 10)
  int path_threshold = 0;              // least points of a closed path; 0 takes path_k + 1 (section 3.2)
  double length_exponent = 0.9;        // of the number of points in eq. (3)
  int population = 100;                // best paths that enter Algorithm 3.2
  int generations = 100;               // K of Algorithm 3.2 (section 4)
  double mutation_probability = 1e-3;  // per bit; the paper says "low"  [ours]
  std::int64_t max_path_steps = 2'000'000'000;  // limit on the neighbours visited in Algorithm 3.1  [ours]
};

// The loops that are returned.
enum class LoopPolicy {
  All,
  Outer,    // the outer loop of each component
  Largest,  // the outer loop of the component with most points
};

// "all", "outer", "largest".
const char* name(LoopPolicy policy);

// How the triangles of the surface are chosen among the candidates; nothing else depends on it.
enum class RimSearch {
  Greedy,   // each by its own size
  Climb,    // from several starts, single flips while they raise the fitness; the fittest result
  Genetic,  // these results as the first population, which exchange regions
};

// "greedy", "climb", "genetic".
const char* name(RimSearch search);

// All boundary loops, in order: the preset `default`, in place of sections 3.2 to 3.4. [ours, docs/default-
// method.md]
struct BoundaryLoopOptions {
  LoopPolicy loop_policy = LoopPolicy::All;
  int min_loop = 6;              // points of a loop that is returned, at least 3
  double min_probability = 0.4;  // of a loop that is returned; noise of half a spacing leaves about 0.5
  RimSearch search = RimSearch::Genetic;
  int rim_population = 12;   // chromosomes per group of candidate triangles; of the search climb its starts
  int rim_generations = 30;  // at most, of the genetic search; 0 is the search climb
};

// The domain that a patch is mapped to.
enum class Domain {
  Disc,       // the unit disc, the outer loop on the circle by chord length (section 5)
  Square,     // the unit square; its sides bulge by a thousandth, so that no triangle there is flat
  Rectangle,  // of width 1, its height from the lengths of the loop's sides; bulging likewise
  Free,       // least squares conformal with a free outline, at the scale of the surface
  None,       // no map at all: u and v are NaN
};

// "disc", "square", "rectangle", "free", "none".
const char* name(Domain domain);
// Whether there is a map: of any domain but None.
bool has_map(Domain domain);

// The scale of the map. [ours]
enum class UvScale {
  Domain,  // size of the domain: 1, or the scale of the surface for the domain Free
  Unit,    // all charts together in the square from 0 to 1
  Real,    // each component has the area that its surface has
};

// "domain", "unit", "real".
const char* name(UvScale scale);

// Section 5: from the loop to the plane.
struct ParameterizeOptions {
  Domain domain = Domain::Disc;  // the paper's presets know the disc alone
  // Of square and rectangle: ids of four points of one outer loop, in its order from the corner at (0, 0)
  // or in any; none: where the loop turns most. [ours]
  std::array<Index, 4> corners{none, none, none, none};
  int map_k = 20;           // neighbours per interior point in eq. (4)  [ours; the paper gives none]
  double residual = 1e-10;  // of the linear system, relative to its right-hand side
  int charts = 0;  // of each component: 1 cuts only what is no disc with holes; 0 takes as many as keep
                   // the stretch of free maps low; more cuts into at least so many [ours]
  UvScale uv_scale = UvScale::Domain;
};

// The holes that are closed by triangles; the others are loops of the mesh's boundary. [ours]
struct HolePolicy {
  bool fill = false;             // else all are kept
  std::int64_t most_points = 0;  // on the rim of a hole that is filled; 0: any number
  double most_length = 0;        // of such a rim, in the unit of the input; 0: any length

  friend bool operator==(const HolePolicy&, const HolePolicy&) = default;
};

// "keep", "fill", "fill:30" (points of the rim), "fill:2.5u" (length of the rim in the unit of the input).
std::string name(const HolePolicy& holes);

// The reverse. Throws BadOption with what is allowed.
HolePolicy parse_holes(std::string_view text);

// Treatment of handles that are a few spacings long: they are noise, not shape. [ours]
enum class HandlePolicy {
  Repair,  // cut or closed where that changes few triangles
  Keep,
};

// "repair", "keep".
const char* name(HandlePolicy handles);

// Section 5: from the plane to the mesh.
struct MeshOptions {
  HolePolicy holes;          // the paper's presets fill every hole through the map
  bool fill_points = false;  // new vertices where holes are filled, at the spacing of the rim [ours]
  Point up = {0, 0, 1};      // the mesh faces this way on average, where the input has no normals
  int refine_rounds = 4;     // upper bound of the rounds of triangulating the map anew [ours]
  HandlePolicy handles = HandlePolicy::Repair;
  bool strict = false;  // a point in no triangle makes the whole run fail, unless it is stray [ours]
};

struct Options {
  Preset preset = Preset::Default;
  BoundaryOptions boundary;
  LoopOptions loops;
  BoundaryLoopOptions boundary_loops;
  ParameterizeOptions map;
  MeshOptions mesh;
};

// The presets in which an option has an effect.
enum class UsedBy {
  All,
  Default,  // the preset `default` alone
  Paper,    // the presets `paper` and `paper-log`
  Capped,   // likewise, with the score form Capped
};

// The number of neighbours that a run finds for each point.
int most_neighbours(const Options& options);

// The defaults of a preset.
Options preset_options(Preset preset);

// Whether an option has an effect under these options.
bool counts(UsedBy used_by, const Options& options);

// "of the preset default alone", "of the presets paper and paper-log alone", ...; "" for All.
std::string where_used(UsedBy used_by);

// Throws BadOption where a field is out of its range, with the name, the value and the range; and where an
// option that has no effect is not at its default, with the presets that use it.
void check_options(const Options& options);

// One field of the options as the tool, the report and the docs see it. `name` has the spelling of C++
// ("length_exponent"); the tool writes a dash for each underscore.
template <class T>
struct Field {
  const char* name;
  T& value;
  std::remove_const_t<T> least, most;  // the range, both ends included (equal where T is not a number)
  const char* help;                    // one line: what it is, its unit, its source
  UsedBy used_by;                      // the presets in which it has an effect
  const char* zero = "";  // the word for 0, where there is one: 0 leaves the choice to the method
};

// Calls visit(Field<T>) for each field but `up`, `holes` and `corners`, T being int, std::int64_t, double,
// bool or an enumeration with a name() (Field::least and most are equal there; a bool goes from false to
// true). Names are unique over all structs.
template <class AnyOptions, class Visit>
void visit_fields(AnyOptions& o, Visit&& visit) {
  constexpr double tiny = 1e-300;
  constexpr std::int64_t huge = std::int64_t{1} << 62;
  const auto field = [&visit]<class T>(const char* id, T& value, auto least, auto most, const char* help,
                                       UsedBy used_by = UsedBy::All, const char* zero = "") {
    using Value = std::remove_const_t<T>;
    visit(Field<T>{id, value, static_cast<Value>(least), static_cast<Value>(most), help, used_by, zero});
  };
  field("k", o.boundary.k, 3, 1000, "neighbours in the chi-square test (section 4)");
  field("sectors", o.boundary.sectors, 2, 360, "r of eq. (1), equal slices of the circle (section 4)");
  field("significance", o.boundary.significance, tiny, 1.0, "alpha: candidates have p <= alpha (section 4)");
  field("score_form", o.loops.score_form, ScoreForm::Printed, ScoreForm::Printed,
        "eq. (2) as printed (1/p), capped (1/max(p, score_cap), section 3.3: an approximation) or its log "
        "[ours]",
        UsedBy::Paper);
  field("score_cap", o.loops.score_cap, tiny, 1.0, "lower bound of p in the score form capped [ours]",
        UsedBy::Capped);
  field("path_k", o.loops.path_k, 1, 1000, "neighbours in Algorithm 3.1 (section 4)", UsedBy::Paper);
  field("path_threshold", o.loops.path_threshold, 0, 1'000'000'000,
        "least points of a closed path; 0 takes path_k + 1 (section 3.2)", UsedBy::Paper);
  field("length_exponent", o.loops.length_exponent, 0.0, 2.0, "exponent of the length in eq. (3)");
  field("population", o.loops.population, 1, 100'000, "chromosomes in Algorithm 3.2 (section 3.4)",
        UsedBy::Paper);
  field("generations", o.loops.generations, 0, 1'000'000, "K of Algorithm 3.2 (section 4)", UsedBy::Paper);
  field("mutation_probability", o.loops.mutation_probability, 0.0, 1.0, "per bit (section 3.1: low)",
        UsedBy::Paper);
  field("max_path_steps", o.loops.max_path_steps, 1, huge, "bound on the work of Algorithm 3.1 [ours]",
        UsedBy::Paper);
  field(
      "loop_policy", o.boundary_loops.loop_policy, LoopPolicy::All, LoopPolicy::All,
      "the loops that are returned: all, the outer one of each component, or the largest component's [ours]",
      UsedBy::Default);
  field("min_loop", o.boundary_loops.min_loop, 3, 1'000'000'000, "least points of a returned loop [ours]",
        UsedBy::Default);
  field("min_probability", o.boundary_loops.min_probability, 0.0, 1.0,
        "least probability of a returned loop [ours]", UsedBy::Default);
  field("search", o.boundary_loops.search, RimSearch::Genetic, RimSearch::Genetic,
        "how the triangles of the surface are chosen: greedy by size alone, climb by the fitness of the whole "
        "boundary from several starts, genetic by breeding what climb finds [ours]",
        UsedBy::Default);
  field("rim_population", o.boundary_loops.rim_population, 2, 100'000,
        "chromosomes per group of candidate triangles, or starts of the search climb [ours]", UsedBy::Default);
  field("rim_generations", o.boundary_loops.rim_generations, 0, 1'000'000,
        "upper bound of the generations of a group; 0 is the search climb [ours]", UsedBy::Default);
  field("domain", o.map.domain, Domain::Disc, Domain::Disc,
        "domain of a patch's map: free is least squares conformal at real scale, none makes no map [ours]",
        UsedBy::Default);
  field("map_k", o.map.map_k, 3, 1000, "neighbours per interior point in eq. (4) [ours]", UsedBy::Paper);
  field("residual", o.map.residual, 1e-15, 1e-2, "relative residual of the solve of eq. (4)");
  field("charts", o.map.charts, 0, 1'000'000,
        "charts of each component: 1 cuts only surfaces that are not discs with holes; auto also cuts free "
        "maps until their stretch is at most 2 on average and 100 at worst; N makes at least N charts [ours]",
        UsedBy::Default, "auto");
  field("uv_scale", o.map.uv_scale, UvScale::Domain, UvScale::Domain,
        "size of the map: the domain's own, unit for the square from 0 to 1, real for the area of the "
        "surface [ours]",
        UsedBy::Default);
  field("refine_rounds", o.mesh.refine_rounds, 1, 100,
        "upper bound of the rounds of triangulating the map anew [ours]", UsedBy::Default);
  field("fill_points", o.mesh.fill_points, false, true,
        "new vertices where holes are filled, at the spacing of their rims [ours]", UsedBy::Default);
  field("handles", o.mesh.handles, HandlePolicy::Repair, HandlePolicy::Repair,
        "short handles, which are noise: repair cuts or closes them where that changes few triangles [ours]",
        UsedBy::Default);
  field("strict", o.mesh.strict, false, true,
        "fail with status 3 where a point is in no triangle, unless it is stray [ours]", UsedBy::Default);
}

}  // namespace rimline
