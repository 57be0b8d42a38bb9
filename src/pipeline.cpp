// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "parallel.h"
#include "rimline/arrange.h"
#include "rimline/boundary.h"
#include "rimline/exact_loops.h"
#include "rimline/loops.h"
#include "rimline/measure.h"
#include "rimline/neighbours.h"
#include "rimline/parameterize.h"
#include "rimline/refine.h"
#include "rimline/triangulate.h"
#include "stage_clock.h"

namespace rimline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// One run of the method over one input. The members are the results of the stages in their order, in the ids
// of the arrangement; what leaves is translated to the ids of the input.
class Pipeline {
 public:
  Pipeline(Points input, const Options& options, const Run& run, const Given& given)
      : input_(input), options_(options), run_(run), given_(given) {
    check_options(options);
    check_given();
  }

  BoundaryResult boundary() {
    find_loops();
    return boundary_result();
  }
  ParameterizeResult parameterize() {
    find_loops();
    is_paper() ? map_to_the_disc() : mesh_patches();
    ParameterizeResult result;
    result.uv = uv_of_input();
    result.boundary = boundary_result();
    return result;
  }
  ReconstructResult reconstruct() {
    find_loops();
    if (is_paper()) {
      map_to_the_disc();
      triangulate_the_disc();
    } else {
      mesh_patches();
    }
    measure();
    ReconstructResult result;
    result.uv = uv_of_input();
    result.triangles = triangles_of_input();
    result.patch = patch_of_input();
    result.boundary = boundary_result();
    return result;
  }

 private:
  void check_given() const {
    if (is_paper() && options_.map.domain != Domain::Disc) {
      throw Error(ErrorCode::BadOption,
                  "the paper's presets map to the disc alone; take the preset default for others");
    }
    if (!given_.normals.empty() && given_.normals.size() != input_.size()) {
      throw Error(ErrorCode::BadOption, "there must be one normal per point, or none");
    }
    for (const Loop& loop : given_.loops) {
      for (const Index id : loop.points) {
        if (id < 0 || id >= static_cast<Index>(input_.size())) {
          throw Error(ErrorCode::BadOption, "a given loop names a point that the input does not have", {id});
        }
      }
    }
  }

  // Errors of the stages name points of the arrangement; users know those of their file.
  template <class Body>
  auto translate_errors(const Body& body) const {
    try {
      return body();
    } catch (const Error& error) {
      std::vector<Index> ids;
      for (const Index id : error.ids()) ids.push_back(arrangement_.ids[id]);
      std::sort(ids.begin(), ids.end());
      throw Error(error.code(), error.what(), std::move(ids));
    }
  }

  int most_neighbours() const {
    return std::max({options_.boundary.k, options_.loops.path_k, options_.map.map_k, 6});
  }

  void prepare() {
    clock_.enter(Stage::Arrange);
    arrangement_ = arrange(input_, run_);
    clock_.enter(Stage::Neighbours);
    neighbours_ = find_neighbours(arrangement_.points, most_neighbours(), run_);
    if (leave_out_stray(arrangement_, neighbours_)) {
      neighbours_ = find_neighbours(arrangement_.points, most_neighbours(), run_);
    }
    spacing_ = local_spacing(neighbours_);
    report_.points = {input_.size(), arrangement_.points.size(), arrangement_.not_finite.size(),
                      arrangement_.duplicates.size(), arrangement_.stray.size()};
    report_.spacing = summarize_spacing(spacing_);
  }

  bool is_paper() const { return options_.preset != Preset::Default; }

  void find_loops() {
    prepare();
    clock_.enter(Stage::Boundary);
    scores_ = score_boundary(arrangement_.points, neighbours_, options_.boundary, run_);
    report_assumptions();
    clock_.enter(Stage::Loops);
    if (!is_paper()) {
      find_all_loops();
    } else if (given_.loops.empty()) {
      find_loop_of_the_paper();
    }
    if (!given_.loops.empty()) take_given_loops();
  }

  // Section 3, Algorithms 3.1 and 3.2.
  void find_loop_of_the_paper() {
    GeneticLoop found = translate_errors(
        [&] { return find_genetic_loop(arrangement_.points, neighbours_, scores_, options_.loops, run_); });
    report_.search = std::move(found.search);
    loops_ = {std::move(found.loop)};
    if (report_.search.bound_hit) {
      report_.warnings.push_back(fmt::format(
          "the search for closed paths stopped at its bound of {} steps after {} of {} candidates; raise "
          "max_path_steps to search them all",
          options_.loops.max_path_steps, report_.search.starts, report_.candidates));
    }
  }

  // Ours: every loop of every component.
  void find_all_loops() {
    BoundarySurvey found = translate_errors([&] {
      return find_exact_loops(arrangement_.points, neighbours_, scores_, options_.exact,
                              options_.loops.length_exponent, run_);
    });
    loops_ = std::move(found.loops);
    probability_ = std::move(found.probability);
    label_ = std::move(found.label);
    // Triangles that end at other loops than those given would tell the parts wrongly apart.
    if (given_.loops.empty()) surveyed_ = std::move(found.triangles);
    report_.search.doubtful = found.search.doubtful;
    report_.search.groups = found.search.groups;
    report_.search.greedy_fitness = found.search.greedy;
    report_.search.history = std::move(found.search.history);
    if (loops_.empty() && given_.loops.empty()) {
      report_.warnings.push_back("no loop was found: the surface is closed, or its boundary can not be told");
    }
  }

  void report_assumptions() {
    AssumptionSummary& a = report_.assumptions;
    a.delta = *std::min_element(scores_.delta.begin(), scores_.delta.end());
    a.below_delta =
        std::count_if(scores_.delta.begin(), scores_.delta.end(), [](float d) { return d < 0.05f; });
    const int k = std::min(options_.boundary.k, neighbours_.k);
    a.points_per_sector = static_cast<double>(k) / options_.boundary.sectors;
    a.chi_square_valid = a.points_per_sector >= 5;
    if (!a.chi_square_valid) {
      report_.warnings.push_back(
          fmt::format("{} neighbours over {} sectors are {:.3g} a sector; the chi-square law wants at least "
                      "5 (section 2.3)",
                      k, options_.boundary.sectors, a.points_per_sector));
    }
    report_.candidates = std::count(scores_.candidate.begin(), scores_.candidate.end(), 1);
  }

  // Loops made by hand come in ids of the input. A point that takes no part can not be on one.
  void take_given_loops() {
    std::vector<Index> arranged(input_.size(), none);
    for (std::size_t i = 0; i < arrangement_.ids.size(); ++i)
      arranged[arrangement_.ids[i]] = static_cast<Index>(i);
    std::vector<Index> out;
    loops_ = given_.loops;
    for (Loop& loop : loops_) {
      for (Index& id : loop.points) {
        if (arranged[id] == none) out.push_back(id);
        id = arranged[id];
      }
    }
    if (!out.empty()) {
      std::sort(out.begin(), out.end());
      const std::string message = fmt::format(
          "{} points of the given loops take no part (duplicate, not finite or stray)", out.size());
      throw Error(ErrorCode::BadOption, message, std::move(out));
    }
    for (PointLabel& label : label_) {
      if (label == PointLabel::Boundary) label = PointLabel::Interior;
    }
    for (Loop& loop : loops_) {
      if (!label_.empty()) {
        for (const Index id : loop.points) label_[id] = PointLabel::Boundary;
      }
      loop.length = loop_length(arrangement_.points, loop.points);
      loop.fitness = fitness(loop.points, scores_, options_.loops);
    }
  }

  // The loop that becomes the rim of the disc: the longest outer one. Others are filled (section 6).
  Loop& rim() {
    return *std::max_element(loops_.begin(), loops_.end(), [](const Loop& a, const Loop& b) {
      return std::pair(a.kind == LoopKind::Outer, a.length) < std::pair(b.kind == LoopKind::Outer, b.length);
    });
  }

  // Section 5, eq. (4).
  void map_to_the_disc() {
    clock_.enter(Stage::Parameterize);
    DiscMap found = translate_errors(
        [&] { return map_to_disc(arrangement_.points, neighbours_, rim().points, options_.map, run_); });
    uv_ = std::move(found.uv);
    report_.has_map = true;
    report_.map = found.summary;
  }

  // Section 5, the Delaunay triangulation.
  void triangulate_the_disc() {
    clock_.enter(Stage::Triangulate);
    triangles_ = delaunay(uv_, run_);
    const std::vector<Point> normals = arranged_normals();
    if (orient_mesh(arrangement_.points, triangles_, normals, options_.mesh.up)) {
      mirror([](Index) { return true; });
    }
  }

  // Ours: each component its own patch, its holes kept, refined by flips in space.
  void mesh_patches() {
    clock_.enter(Stage::Refine);
    check_loops_bound_something();
    RefineOptions refine;
    refine.domain = options_.map.domain;
    refine.rounds = options_.mesh.refine_rounds;
    refine.residual = options_.map.residual;
    refine.allow_partial = options_.mesh.allow_partial;
    Surface surface = translate_errors([&] {
      Surface found = refine_surface(arrangement_.points, neighbours_, loops_, surveyed_, refine, run_);
      if (!given_.loops.empty() && !refine.allow_partial) check_reached(found.left_out);
      return found;
    });
    uv_ = std::move(surface.uv);
    triangles_ = std::move(surface.triangles);
    patch_ = std::move(surface.patch);
    report_.has_map = true;
    for (const PatchReport& patch : surface.patches) report_patch(patch);
    orient_patches(surface.patches.size());
  }

  // Loops made by hand say what the surface is: points that none of them bounds are an error, not a
  // remainder.
  static void check_reached(const std::vector<Index>& left_out) {
    if (left_out.empty()) return;
    const std::string message = fmt::format(
        "{} interior points have no chain of neighbours to a given loop; allow_partial leaves them out",
        left_out.size());
    throw Error(ErrorCode::UnreachableInterior, message, left_out);
  }

  void check_loops_bound_something() const {
    if (!loops_.empty()) return;
    throw Error(
        ErrorCode::NoClosedLoop,
        "no boundary was found, so there is nothing to end the mesh at: the surface is closed, or its "
        "boundary can not be told from the points");
  }

  void report_patch(const PatchReport& patch) {
    report_.map.unknowns += patch.map.unknowns;
    report_.map.iterations += patch.map.iterations;
    report_.map.residual = std::max(report_.map.residual, patch.map.residual);
    ComponentSummary summary{patch.points, patch.triangles, patch.loops, 0, patch.suspect, patch.failure};
    if (!patch.rounds.empty()) summary.bad_edges = patch.rounds.back().bad_edges;
    const std::size_t at = report_.components.size();
    if (patch.suspect) {
      report_.warnings.push_back(fmt::format(
          "component {} is suspect: {:.1f} % of its inner edges are longer than 3 spacings or folded beyond "
          "120 degrees",
          at, 100 * patch.bad_share));
    }
    if (!patch.failure.empty()) {
      report_.warnings.push_back(fmt::format("component {} was not meshed: {}", at, patch.failure));
    }
    report_.components.push_back(std::move(summary));
  }

  // Each patch faces its own way until here.
  void orient_patches(std::size_t count) {
    const std::vector<Point> normals = arranged_normals();
    std::vector<std::vector<Triangle>> parts(count);
    for (const Triangle& t : triangles_) parts[patch_of(t)].push_back(t);
    std::vector<char> turned(count, 0);
    triangles_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      turned[i] = orient_mesh(arrangement_.points, parts[i], normals, options_.mesh.up);
      triangles_.insert(triangles_.end(), parts[i].begin(), parts[i].end());
    }
    mirror([&](Index point) { return patch_[point] != none && turned[patch_[point]]; });
  }

  // A point in which two patches touch counts to one of them; the triangle's other corners decide.
  Index patch_of(const Triangle& t) const {
    return patch_[t[1]] == patch_[t[2]] ? patch_[t[1]] : patch_[t[0]];
  }

  // Seen from the side it faces, the map of a patch that was turned round is mirrored too: triangles stay
  // counter-clockwise in uv, and loops keep the surface on their left.
  template <class Turned>
  void mirror(const Turned& turned) {
    // About the axis of the disc, or about the middle of a box that stands on the axis.
    const bool box = options_.map.domain == Domain::Square || options_.map.domain == Domain::Rectangle;
    double low = 0, high = 0;
    for (Index i = 0; box && i < static_cast<Index>(uv_.size()); ++i) {
      if (!turned(i)) continue;
      low = std::min(low, uv_[i].v);
      high = std::max(high, uv_[i].v);
    }
    for (Index i = 0; i < static_cast<Index>(uv_.size()); ++i) {
      if (turned(i)) uv_[i].v = low + high - uv_[i].v;
    }
    for (Loop& loop : loops_) {
      if (turned(loop.points.front())) std::reverse(loop.points.begin() + 1, loop.points.end());
    }
  }

  std::vector<Point> arranged_normals() const {
    std::vector<Point> normals;
    if (given_.normals.empty()) return normals;
    for (const Index id : arrangement_.ids) normals.push_back(given_.normals[id]);
    return normals;
  }

  void measure() {
    clock_.enter(Stage::Measure);
    report_.has_mesh = true;
    report_.mesh = measure_mesh(arrangement_.points, triangles_, spacing_, uv_);
    report_.points.unmeshed = arrangement_.points.size() - report_.mesh.points_used;
    if (report_.points.unmeshed > 0) {
      report_.warnings.push_back(
          is_paper() ? fmt::format("{} points fell on others in the plane and are in no triangle",
                                   report_.points.unmeshed)
                     : fmt::format("{} points hang together with no loop and are in no triangle",
                                   report_.points.unmeshed));
    }
  }

  std::vector<UV> uv_of_input() const {
    std::vector<UV> uv(input_.size(), UV{nan, nan});
    for (std::size_t i = 0; i < uv_.size(); ++i) uv[arrangement_.ids[i]] = uv_[i];
    return uv;
  }

  std::vector<Index> patch_of_input() const {
    if (patch_.empty()) return {};
    std::vector<Index> patch(input_.size(), none);
    for (std::size_t i = 0; i < patch_.size(); ++i) patch[arrangement_.ids[i]] = patch_[i];
    return patch;
  }

  std::vector<Triangle> triangles_of_input() const {
    std::vector<Triangle> triangles = triangles_;
    for (Triangle& t : triangles) {
      for (Index& id : t) id = arrangement_.ids[id];
    }
    return triangles;
  }

  BoundaryResult boundary_result() {
    const std::size_t n = input_.size();
    BoundaryResult result;
    result.boundary.assign(n, 0);
    result.loop.assign(n, none);
    result.candidate.assign(n, 0);
    result.p_value.assign(n, nan);
    result.score.assign(n, nan);
    if (!is_paper()) {
      result.boundary_probability.assign(n, static_cast<float>(nan));
      result.label.assign(n, PointLabel::Stray);
    }
    for (std::size_t i = 0; i < arrangement_.ids.size(); ++i) {
      const Index id = arrangement_.ids[i];
      result.candidate[id] = scores_.candidate[i];
      result.p_value[id] = p_value(scores_.log_score[i]);
      result.score[id] = score(scores_.log_score[i], options_.loops.score_form);
      if (is_paper()) continue;
      result.boundary_probability[id] = probability_[i];
      result.label[id] = label_[i];
    }
    for (Loop& loop : loops_) {
      for (Index& id : loop.points) id = arrangement_.ids[id];
    }
    mark_loops(result);
    count_undersampled(result);
    clock_.leave();
    report_.options = options_;
    report_.seed = run_.seed;
    report_.loops = loops_;
    report_.threads = thread_count(run_);
    report_.stages = clock_.costs();
    result.loops = std::move(loops_);
    result.report = std::move(report_);
    return result;
  }

  // The paper's by-product (section 6): candidates that are not on the boundary. Ours has a label for them.
  void count_undersampled(const BoundaryResult& result) {
    report_.undersampled = 0;
    for (std::size_t i = 0; i < input_.size(); ++i) {
      report_.undersampled += is_paper() ? result.candidate[i] && !result.boundary[i]
                                         : result.label[i] == PointLabel::Undersampled;
    }
  }

  // A point that two loops share carries the id of the longer one.
  void mark_loops(BoundaryResult& result) const {
    for (Index l = 0; l < static_cast<Index>(loops_.size()); ++l) {
      for (const Index id : loops_[l].points) {
        result.boundary[id] = 1;
        Index& mark = result.loop[id];
        if (mark == none || loops_[mark].length < loops_[l].length) mark = l;
      }
    }
  }

  Points input_;
  const Options& options_;
  const Run& run_;
  const Given& given_;
  Report report_;
  StageClock clock_;

  Arrangement arrangement_;
  Neighbours neighbours_;
  std::vector<double> spacing_;
  BoundaryScores scores_;
  std::vector<float> probability_;
  std::vector<PointLabel> label_;
  std::vector<Triangle> surveyed_;
  std::vector<Loop> loops_;
  std::vector<UV> uv_;
  std::vector<Index> patch_;
  std::vector<Triangle> triangles_;
};

}  // namespace

BoundaryResult find_boundary(Points points, const Options& options, const Run& run, const Given& given) {
  return Pipeline(points, options, run, given).boundary();
}

ParameterizeResult parameterize(Points points, const Options& options, const Run& run, const Given& given) {
  return Pipeline(points, options, run, given).parameterize();
}

ReconstructResult reconstruct(Points points, const Options& options, const Run& run, const Given& given) {
  return Pipeline(points, options, run, given).reconstruct();
}

}  // namespace rimline
