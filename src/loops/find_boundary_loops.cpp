// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/compaction.h"
#include "base/parallel.h"
#include "evidence/corner_histogram.h"
#include "evidence/cut_plane.h"
#include "evidence/empty_ball.h"
#include "evidence/jaggedness.h"
#include "evidence/probability.h"
#include "local/anisotropy.h"
#include "local/frame.h"
#include "local/irregularity.h"
#include "local/noise.h"
#include "local/star.h"
#include "loops/smooth_curve/smooth_loop.h"
#include "rimline/boundary_loops.h"
#include "rimline/find_genetic_loop.h"
#include "search/false_ears.h"
#include "search/selection_search.h"
#include "surface/components.h"
#include "surface/local_size.h"
#include "surface/propose.h"
#include "surface/range_image.h"
#include "surface/rims.h"

namespace rimline {

const char* name(PointLabel label) {
  constexpr std::array names{"interior", "boundary", "undersampled", "crease", "stray"};
  return names[static_cast<std::size_t>(label)];
}

namespace {

constexpr double largest_proposed = 4.0;  // spacings; the rim search takes away what is too much
constexpr std::size_t least_gap = 6;  // points of a gap that is told from a boundary; smaller ones say little
constexpr double largest_refilled = 1.0;  // spacings; missing ears are filled with at once
constexpr double deepest_at_cut = 1;      // spacings behind the outermost points of a rim cut by a plane
constexpr double folded = 0.15;           // frame thickness of a neighbourhood that is no patch
constexpr std::size_t least_sheet = 10;   // triangles; smaller scraps are no surface

void check(Points points, const BoundaryLoopOptions& options) {
  if (points.size() < 4) {
    throw Error(ErrorCode::TooFewPoints,
                "loops need at least 4 points, there are " + std::to_string(points.size()));
  }
  if (options.min_loop < 3) throw Error(ErrorCode::BadOption, "min_loop must be at least 3");
  if (options.rim_population < 2) throw Error(ErrorCode::BadOption, "rim_population must be at least 2");
  if (options.rim_generations < 0) throw Error(ErrorCode::BadOption, "rim_generations must not be negative");
}

// One survey: the members are what the steps find, in their order.
class Survey {
 public:
  Survey(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
         const BoundaryLoopOptions& options, double length_exponent, const NoiseModel& noise_model,
         const std::optional<RangeImage>& image, std::vector<double> spacing, const Run& run)
      : points_(points),
        neighbours_(neighbours),
        scores_(scores),
        options_(options),
        length_exponent_(length_exponent),
        noise_model_(noise_model),
        run_(run),
        spacing_(std::move(spacing)),
        frames_(fit_frames(points, neighbours, run)),
        image_(image),
        set_(propose()),
        sizes_(set_, neighbours, run) {}

  BoundaryLoops find() {
    run_.progress(Stage::Loops, 0, points_.size());
    search();
    open_jagged_rims();
    parts_ = orient_components(set_, selected_, run_);
    measure_sheets();
    collect_loops();
    classify();
    apply_policy();
    rate_points();
    if (noise_model_.noise > 0 || noise_model_.irregular > 0) smooth_loops();
    if (!image_) rate_at_cuts();
    rate_loops();
    label_rims();
    result_.triangles = KeptItems(selected_, Stage::Loops, run_).of(set_.triangles());
    return std::move(result_);
  }

 private:
  struct Candidate {
    Loop loop;
    bool returned = false;
  };

  TriangleSet propose() const {
    if (image_) return range_image_triangles(points_, frames_, *image_);
    return propose_surface(points_, frames_,
                           find_delaunay_stars(points_, neighbours_, spacing_, frames_, run_), spacing_,
                           largest_proposed, run_);
  }

  void search() {
    SearchOptions o;
    o.population = options_.rim_population;
    o.generations = options_.rim_generations;
    if (noise_model_.noise > 0) {
      // Noise spreads the sizes of triangles, but opens no holes as chance does among random points.
      constexpr double by_noise = 1;
      const auto blend = [&](double& cost) { cost = by_noise + (cost - by_noise) * noise_model_.irregular; };
      blend(o.weights.hole_prior);
      blend(o.weights.hole_prior_spread);
    }
    result_.search.history.assign(options_.rim_generations, {});
    if (image_) {  // leaves no doubt
      selected_.assign(set_.size(), 1);
      return;
    }
    const std::vector<double> evenness = look_twice(o);
    // The large triangles that are gone had turned edges of the rim; with them out of the way the ears
    // they leave can be seen for what they are, so the search looks again.
    keep_and_refill();
    take(SelectionSearch(set_, sizes_, find_excluded(), o, run_).find(evenness));
    sizes_.drop_limits();
  }

  // Rims that turn out to be even all along are likely so where they seem not to be: looked for once more,
  // with that known. Noise blurs what is even. Returns how even rims are, where that is known.
  std::vector<double> look_twice(const SearchOptions& options) {
    const SelectionSearch rims(set_, sizes_, find_excluded(), options, run_);
    take(rims.find({}));
    if (noise_model_.noise > 0 || options.generations == 0) return {};
    std::vector<double> even = evenness(points_, walk_rims(set_, selected_, run_), run_);
    take(rims.find_again(even, selected_));
    return even;
  }

  void take(SearchResult found) {
    SelectionSummary& summary = result_.search;
    summary.doubtful += found.doubtful;
    summary.groups += found.groups;
    summary.greedy += found.greedy;
    summary.best += found.best;
    for (int i = 0; i < options_.rim_generations; ++i) {
      summary.history[i].best += found.history_best[i];
      summary.history[i].mean += found.history_mean[i];
    }
    selected_ = std::move(found.selected);
  }

  void keep_and_refill() {
    std::vector<std::uint8_t> changed(points_.size(), 0);
    const auto mark = [&](const Triangle& t) {
      for (const Index v : t) std::atomic_ref(changed[v]).store(1, std::memory_order_relaxed);
    };
    parallel_for_each(set_.size(), Stage::Loops, run_, [&](Index t) {
      if (!selected_[t]) mark(set_.triangle(t));
    });
    set_.keep_only(selected_, run_);
    const Index selected = set_.size();
    fill_missing_ears(set_, spacing_, largest_refilled, run_);
    for (Index t = selected; t < set_.size(); ++t) mark(set_.triangle(t));
    sizes_.forget(changed, run_);
  }

  // Marks the points of rims that are no boundary, as they stand: at creases and thin walls stars do not
  // agree and leave gaps, which the search would only tear open.
  std::vector<std::uint8_t> find_excluded() const {
    const Selection all(set_.size(), 1);
    std::vector<std::uint8_t> excluded(points_.size(), 0);
    for (const auto& loop : walk_rims(set_, all, run_)) {
      if (loop.size() < least_gap || rim_probability(loop, all) >= 0.5) continue;
      for (const Index v : loop) excluded[v] = 1;
    }
    return excluded;
  }

  // Not among random points, whose rims look jagged by chance.
  void open_jagged_rims() {
    if (image_ || noise_model_.noise > 0 || noise_model_.irregular >= 0.5 || options_.rim_generations == 0)
      return;
    behind_false_ear_.assign(points_.size(), 0);
    auto rims = boundary_rims();
    corners_ = CornerHistogram(set_, sizes_, neighbours_, rims, selected_);
    // The rim shows how jagged it is only when the first ears are open, and what is behind them.
    constexpr int layers = 2;
    for (int layer = 1;; ++layer) {
      const std::vector<Index> opened = remove_false_ears(set_, sizes_, corners_, rims, selected_);
      for (const Index v : opened) behind_false_ear_[v] = 1;
      if (opened.empty() || layer == layers) break;
      rims = boundary_rims();
    }
  }

  std::vector<std::vector<Index>> boundary_rims() const {
    std::vector<std::vector<Index>> rims = walk_rims(set_, selected_, run_);
    std::erase_if(rims, [&](const auto& rim) {
      return static_cast<int>(rim.size()) < options_.min_loop ||
             boundary_probability(rim) < options_.min_probability;
    });
    return rims;
  }

  // Adds to a sum that others add to, too: whole numbers give the same sum in any order.
  template <class Number>
  static void add(Number& sum, Number count) {
    if (count != 0) std::atomic_ref(sum).fetch_add(count, std::memory_order_relaxed);
  }

  void measure_sheets() {
    result_.components.resize(parts_.count());
    std::vector<std::size_t> edges_twice(parts_.count(), 0);
    parallel_slices(set_.size(), Stage::Loops, run_, [&](std::size_t begin, std::size_t end) {
      std::size_t triangles = 0, edges = 0;
      for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t) {
        if (!selected_[t]) continue;
        const Index c = parts_.of_triangle[t];
        ++triangles;
        for (int k = 0; k < 3; ++k) {
          const Index other = set_.across(t, k);
          edges += other != none && selected_[other] ? 1 : 2;
        }
        if (static_cast<std::size_t>(t) + 1 < end && parts_.of_triangle[t + 1] == c) continue;
        add(result_.components[c].triangles, std::exchange(triangles, 0));
        add(edges_twice[c], std::exchange(edges, 0));
      }
    });
    visit_stars();
    for (Index c = 0; c < parts_.count(); ++c) {
      SurfaceComponent& s = result_.components[c];
      s.orientable = parts_.orientable[c];
      s.euler = static_cast<long long>(s.points) - static_cast<long long>(edges_twice[c] / 2) +
                static_cast<long long>(s.triangles);
    }
  }

  // Counts the points of each component, and tells those that are on a surface from the others.
  void visit_stars() {
    result_.label.resize(points_.size());
    parallel_slices(points_.size(), Stage::Loops, run_, [&](std::size_t begin, std::size_t end) {
      std::vector<Index> here;  // components that a vertex is on
      Index last = none;
      std::size_t points = 0;  // on the last of them
      for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
        here.clear();
        Index newest = none;  // most triangles are on the same as the one before
        bool on_surface = false;
        for (const Index t : set_.star(v)) {
          const Index c = parts_.of_triangle[t];
          if (c == none || c == newest || std::find(here.begin(), here.end(), c) != here.end()) continue;
          newest = c;
          here.push_back(c);
          on_surface |= result_.components[c].triangles >= least_sheet;
          if (c != last && last != none) add(result_.components[last].points, std::exchange(points, 0));
          last = c;
          ++points;
          if (static_cast<Index>(here.size()) == parts_.count()) break;  // there are no others
        }
        result_.label[v] = on_surface ? PointLabel::Interior : PointLabel::Stray;
      }
      if (last != none) add(result_.components[last].points, points);
    });
  }

  Index triangle_at(Index a, Index b) const { return selected_triangle(set_, selected_, a, b); }

  void collect_loops() {
    for (auto& ids : walk_rims(set_, selected_, run_)) {
      Candidate c;
      const Index t = triangle_at(ids[0], ids[1]);
      c.loop.component = parts_.of_triangle[t];
      c.loop.points = std::move(ids);
      c.loop.length = loop_length(points_, c.loop.points);
      c.loop.probability = boundary_probability(c.loop.points);
      c.returned = static_cast<int>(c.loop.points.size()) >= options_.min_loop &&
                   c.loop.probability >= options_.min_probability &&
                   result_.components[c.loop.component].triangles >= least_sheet;
      candidates_.push_back(std::move(c));
    }
  }

  double boundary_probability(const std::vector<Index>& ids) const {
    return rim_probability(ids, selected_) * (image_ ? 1 : no_gap(isoperimetric_ratio(ids)));
  }

  // Its vector area over that of a disc whose radius is the largest spacing on it.
  double isoperimetric_ratio(const std::vector<Index>& ids) const {
    double largest = 0;
    Point area;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Point a = points_[ids[i]], b = points_[ids[i + 1 < ids.size() ? i + 1 : 0]];
      area = area + 0.5 * cross(a - points_[ids[0]], b - points_[ids[0]]);
      largest = std::max(largest, spacing_[ids[i]]);
    }
    return norm(area) / (std::numbers::pi * largest * largest);
  }

  double rim_probability(const std::vector<Index>& ids, const Selection& selected) const {
    if (image_) return range_image_loop_probability(ids.size());
    const auto look = [&](std::size_t i, std::vector<double>& found) {
      const Index a = ids[i], b = ids[i + 1 < ids.size() ? i + 1 : 0];
      if (behind_false_ear(a) || behind_false_ear(b)) return;
      const Index apex = set_.apex(selected_triangle(set_, selected, a, b), a, b);
      found.push_back(empty_ball_radius(points_, neighbours_, spacing_, a, b, apex));
    };
    constexpr std::size_t in_task = 256, few = 4 * in_task;  // edges
    std::vector<double> empty;
    if (ids.size() < few) {
      for (std::size_t i = 0; i < ids.size(); ++i) look(i, empty);
    } else {
      empty = parallel_gather<double>(ids.size(), Stage::Loops, run_, look, in_task);
    }
    double thickness = 0;
    for (const Index id : ids) thickness += frames_[id].thickness / static_cast<double>(ids.size());
    if (empty.empty()) return 0;
    std::nth_element(empty.begin(), empty.begin() + empty.size() / 2, empty.end());
    // Under noise what lies beyond a small opening is too blurred to outweigh that its rim looks like a
    // crease.
    const double bend =
        noise_model_.noise > 0 ? no_gap(isoperimetric_ratio(ids)) * thickness_of_opening(ids.size()) : 0;
    return loop_probability(ids.size(), empty[empty.size() / 2], std::max(0.0, thickness - bend));
  }

  // Ears are as narrow as the samples behind them and say nothing of what lies beyond the rim.
  bool behind_false_ear(Index v) const { return !behind_false_ear_.empty() && behind_false_ear_[v]; }

  // How much a loop looks like the outer one of its component: its extent, more where the surface lies inside
  // it, less where it lies around it.
  double outer_rank(const Loop& loop) const {
    Point low = points_[loop.points[0]], high = low, area, normal;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Index a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
      const Point p = points_[a];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      area = area + 0.5 * cross(p - points_[loop.points[0]], points_[b] - points_[loop.points[0]]);
      const Triangle& t = set_.triangle(triangle_at(a, b));
      const Point n = cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
      normal = normal + (distance(p, points_[b]) / std::max(norm(n), 1e-300)) * n;
    }
    // -1 for a flat hole, 1 for a flat outline, 0 where the surface stands upright on the loop.
    const double lies = dot(area, normal) / std::max(norm(area) * loop.length, 1e-300);
    return distance(low, high) * std::exp(lies);
  }

  void classify() {
    std::vector<double> best(parts_.count(), -1);
    std::vector<std::size_t> outer(parts_.count());
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      Candidate& c = candidates_[i];
      if (!c.returned) continue;
      c.loop.kind = LoopKind::Hole;
      const double rank = outer_rank(c.loop);
      if (rank > best[c.loop.component]) {
        best[c.loop.component] = rank;
        outer[c.loop.component] = i;
      }
    }
    for (Index s = 0; s < parts_.count(); ++s) {
      if (best[s] >= 0) candidates_[outer[s]].loop.kind = LoopKind::Outer;
    }
  }

  void apply_policy() {
    Index largest = none;
    for (const Candidate& c : candidates_) {
      if (!c.returned) continue;
      const auto& all = result_.components;
      if (largest == none || all[c.loop.component].points > all[largest].points) largest = c.loop.component;
    }
    for (Candidate& c : candidates_) {
      const bool outer = c.loop.kind == LoopKind::Outer;
      if (options_.loop_policy != LoopPolicy::All && !outer) c.returned = false;
      if (options_.loop_policy == LoopPolicy::Largest && c.loop.component != largest) c.returned = false;
      if (!c.returned) continue;
      ++result_.components[c.loop.component].loops;
      result_.loops.push_back(c.loop);
    }
    std::sort(result_.loops.begin(), result_.loops.end(), [](const Loop& a, const Loop& b) {
      return std::tuple(a.component, a.kind == LoopKind::Hole, -a.length, a.points) <
             std::tuple(b.component, b.kind == LoopKind::Hole, -b.length, b.points);
    });
  }

  void rate_points() {
    const FitnessModel weights;
    result_.probability.assign(points_.size(), static_cast<float>(far_from_rims()));
    for (const Candidate& c : candidates_) {
      const auto& ids = c.loop.points;
      const std::size_t n = ids.size();
      for (std::size_t i = 0; i < n; ++i) {
        const std::array<Index, 5> run{ids[(i + n - 2) % n], ids[(i + n - 1) % n], ids[i], ids[(i + 1) % n],
                                       ids[(i + 2) % n]};
        rate(ids[i], c, ear_log_odds(set_, sizes_, weights, run), true);
        // The point behind the next edge would be on the rim if its triangle were left out.
        const Index inner = set_.apex(triangle_at(run[2], run[3]), run[2], run[3]);
        rate(inner, c, ear_log_odds(set_, sizes_, weights, {run[1], run[2], inner, run[3], run[4]}), false);
      }
      if (!image_) rate_behind_jagged(c);
    }
    for (std::size_t v = 0; image_ && v < points_.size(); ++v) {
      if (set_.star(static_cast<Index>(v)).empty())
        result_.probability[v] = range_image_isolated_probability();
    }
  }

  // Behind a jagged rim lie points that would be on it, had all its ears been seen.
  void rate_behind_jagged(const Candidate& c) {
    const auto& ids = c.loop.points;
    const std::vector<double> jagged = jaggedness(points_, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (jagged[i] == 0) continue;
      raise(ids[i], on_jagged_rim(jagged[i], c.loop.probability));
      const Index a = ids[i], b = ids[i + 1 < ids.size() ? i + 1 : 0];
      const Index behind = set_.apex(triangle_at(a, b), a, b);
      const double odds = false_ear_log_odds(set_, sizes_, corners_, {a, behind, b}, jagged[i]);
      raise(behind, jagged_point_probability(odds, jagged[i], c.loop.probability));
      for (const Index t : set_.star(a)) {
        if (!selected_[t]) continue;
        for (const Index v : set_.triangle(t)) raise(v, behind_jagged_point(jagged[i], c.loop.probability));
      }
    }
  }

  // Where a plane has cut the surface, what lies at the plane as the outermost points of the rim do may be on
  // the boundary, though triangles join it to the others.
  void rate_at_cuts() {
    for (const Loop& loop : result_.loops) {
      const auto plane = CutPlane::find(points_, neighbours_, spacing_, frames_, loop.points);
      if (!plane) continue;
      const std::vector<double> jagged = jaggedness(points_, loop.points);
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const double p = at_cut_probability(jagged[i], loop.probability);
        for (const Index v : neighbours_.of(loop.points[i])) {
          if (result_.probability[v] >= p) continue;
          if (plane->depth(points_, neighbours_, spacing_, frames_, v) < deepest_at_cut) raise(v, p);
        }
      }
    }
  }

  // Loops that share no point keep it so: where two would meet, the later one stays as it was.
  void smooth_loops() {
    std::vector<std::uint8_t> taken(points_.size(), 0);
    const auto mark = [&](const std::vector<Index>& ids, std::uint8_t value) {
      for (const Index id : ids) taken[id] = value;
    };
    for (const Loop& loop : result_.loops) mark(loop.points, 1);
    for (Loop& loop : result_.loops) {
      const SmoothedLoop drawn =
          smooth_loop(points_, neighbours_, spacing_, loop.points, normals_along(loop), noise_model_, run_);
      if (drawn.loop.empty()) continue;
      const double length = loop_length(points_, drawn.loop);
      constexpr double most = 1.5;  // times the length before: triangles cut a third off a small rim
      mark(loop.points, 0);
      const bool meets =
          std::any_of(drawn.loop.begin(), drawn.loop.end(), [&](Index id) { return taken[id]; });
      if (!meets && length <= most * loop.length) {
        for (std::size_t i = 0; i < drawn.near.size(); ++i) {
          result_.probability[drawn.near[i]] =
              static_cast<float>(blurred_probability(drawn.depth[i], noise_model_.noise, loop.probability));
        }
        // Without noise, and among random points, the search knows better which points the line goes through.
        if (noise_model_.noise > 0 && (noise_model_.irregular < 0.5 || noise_model_.anisotropic)) {
          loop.points = drawn.loop;
          loop.length = length;
        }
      }
      mark(loop.points, 1);
    }
  }

  // Of the triangles at its edges.
  std::vector<Point> normals_along(const Loop& loop) const {
    const std::size_t n = loop.points.size();
    std::vector<Point> normals;
    for (std::size_t i = 0; i < n; ++i) {
      const Triangle& t = set_.triangle(triangle_at(loop.points[i], loop.points[(i + 1) % n]));
      const Point normal = cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
      normals.push_back((1 / std::max(norm(normal), 1e-300)) * normal);
    }
    return normals;
  }

  // eq. (3), on the log score -log(1 - p).
  void rate_loops() {
    for (Loop& loop : result_.loops) {
      double sum = 0;
      for (const Index id : loop.points)
        sum -= std::log1p(-std::min(0.999999, double{result_.probability[id]}));
      loop.fitness = sum / std::pow(static_cast<double>(loop.points.size()), length_exponent_);
    }
  }

  void rate(Index id, const Candidate& c, double log_odds, bool on_rim) {
    const double chi_square = scores_.log_score[id];
    const double p = image_ ? range_image_point_probability(on_rim, chi_square, c.loop.probability)
                            : point_probability(log_odds, on_rim, chi_square, c.loop.probability);
    raise(id, p);
  }
  void raise(Index id, double p) {
    result_.probability[id] = std::max(result_.probability[id], static_cast<float>(p));
  }

  void label_rims() {
    auto& label = result_.label;
    for (const Candidate& c : candidates_) {
      if (c.returned) continue;
      for (const Index v : c.loop.points) {
        if (label[v] == PointLabel::Stray) continue;
        label[v] = frames_[v].thickness > folded ? PointLabel::Crease : PointLabel::Undersampled;
      }
    }
    for (const Loop& loop : result_.loops) {
      for (const Index v : loop.points) label[v] = PointLabel::Boundary;
    }
  }

  Points points_;
  const Neighbours& neighbours_;
  const BoundaryScores& scores_;
  const BoundaryLoopOptions& options_;
  double length_exponent_;
  NoiseModel noise_model_;  // noise that is heeded; none where points are clean
  const Run& run_;
  std::vector<double> spacing_;
  std::vector<Frame> frames_;
  std::optional<RangeImage> image_;
  TriangleSet set_;
  LocalSizes sizes_;
  Selection selected_;
  CornerHistogram corners_;
  std::vector<std::uint8_t> behind_false_ear_;  // of points on the rim that were behind it before ears opened
  Components parts_;
  std::vector<Candidate> candidates_;
  BoundaryLoops result_;
};

}  // namespace

BoundaryLoops find_boundary_loops(Points points, const Neighbours& neighbours, const BoundaryScores& scores,
                                  const BoundaryLoopOptions& options, double length_exponent,
                                  const Run& run) {
  return find_boundary_loops(points, neighbours, local_spacing(points, neighbours, run), scores, options,
                             length_exponent, run);
}

BoundaryLoops find_boundary_loops(Points points, const Neighbours& neighbours, std::vector<double> spacing,
                                  const BoundaryScores& scores, const BoundaryLoopOptions& options,
                                  double length_exponent, const Run& run) {
  check(points, options);
  const std::optional<RangeImage> image = find_range_image(points, neighbours, run);
  if (image) {
    BoundaryLoops found =
        Survey(points, neighbours, scores, options, length_exponent, {}, image, std::move(spacing), run)
            .find();
    found.range_scan = true;
    return found;
  }
  const double level = noise_level(points, neighbours, spacing, run);
  // Along scan lines points are closer than the spacing, so that less noise is much there.
  constexpr double least_asked = 0.02;
  const double anisotropy = level > least_asked ? mean_anisotropy(points, neighbours, spacing, run) : 0;
  const double heed = noise_weight(level * std::exp(anisotropy / 2));
  const NoiseModel noise_model{heed > 0 ? level : 0, irregularity(points, neighbours, spacing),
                               anisotropy > 0};
  const auto survey = [&](Points at, const Neighbours& near, std::vector<double> spacing_there) {
    return Survey(at, near, scores, options, length_exponent, noise_model, std::nullopt,
                  std::move(spacing_there), run)
        .find();
  };
  if (heed == 0) return survey(points, neighbours, std::move(spacing));
  // Under noise all geometry is that of points moved onto the surface, as far as their neighbours tell it.
  const std::vector<Point> smooth = take_off_noise(points, neighbours, heed, run);
  const Neighbours near = find_neighbours(smooth, neighbours.k, run);
  for (Index i = 0; i < near.size(); ++i) {
    if (distance_to(smooth, near, i, 0) == 0)
      return survey(points, neighbours, std::move(spacing));  // two were moved to one place
  }
  BoundaryLoops found = survey(smooth, near, local_spacing(smooth, near, run));
  for (Loop& loop : found.loops) loop.length = loop_length(points, loop.points);
  return found;
}

}  // namespace rimline
