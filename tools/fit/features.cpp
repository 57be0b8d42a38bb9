// SPDX-License-Identifier: GPL-3.0-or-later
// What the default method measures at the rims of a point set, beside the truth: what tools/fit/fit fits its
// models to.
//   rimline_features SET.ply
// The set has a property `boundary` (1 on a true loop, 0 not; points with other values are left out). Prints
// one line for each measurement, comma-separated: the term, 1 or 0 as truth has it, then the measures of its
// model:
//   rims           points, thickness, empty ball    each rim of all that is proposed: a boundary?
//   ears           angle, log tail, jaggedness      each triangle at a jagged boundary: a false ear?
//   points_on      ear, chi, rim                    each point of a likely rim: on the boundary?
//   points_behind  ear, chi, rim                    each point behind an edge of one: the same
//   range_rims     points, one-sided                each rim of a range image: a boundary?
//   range_points   chi                              each point on a rim of a range image: the same
//   triangles      each term of the fitness         each triangle along the rims: left out?
// The last one needs the true loops, in SET.loops.json.
// At most a line a rim and four a point of a rim.
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include "evidence/jaggedness.h"
#include "evidence/probability.h"
#include "evidence/rim_probability.h"
#include "local/denoise.h"
#include "rimline/arrange.h"
#include "rimline/io.h"
#include "rimline/score_boundary.h"
#include "search/false_ears.h"
#include "surface/propose.h"
#include "surface/range_image.h"
#include "triangles.h"

using namespace rimline;

namespace {

using Rim = std::vector<Index>;

constexpr double likely =
    0.5;  // probability of a rim whose points are asked for: its factor is 1 from there on

// 1 on a true loop, 0 not, -1 not known, of each arranged point.
std::vector<int> truth_of(const Cloud& cloud, const Arrangement& arranged) {
  const Column* column = cloud.find("boundary");
  if (column == nullptr) throw Error(ErrorCode::CannotRead, "the set has no property `boundary`");
  std::vector<int> truth;
  for (const Index id : arranged.ids) {
    const double value = column->value(id);
    truth.push_back(value == 1 ? 1 : value == 0 ? 0 : -1);
  }
  return truth;
}

void print_rims(const RimEvidence& e, const std::vector<int>& truth, const Run& run) {
  for (const Rim& rim : walk_rims(e.set, e.selection, run)) {
    int on = 0, known = 0;
    for (const Index v : rim) {
      on += truth[v] == 1;
      known += truth[v] >= 0;
    }
    if (2 * known < static_cast<int>(rim.size())) continue;
    if (e.sampling.is_range_image) {
      std::printf("range_rims,%d,%zu,%.6g\n", 2 * on >= known, rim.size(), mean_one_sided(rim, e.samples));
      continue;
    }
    const RimMeasures x = measure_rim(rim, e, run);
    if (!x.is_known) continue;
    std::printf("rims,%d,%zu,%.6g,%.6g\n", 2 * on >= known, rim.size(), x.thickness, x.empty_ball);
  }
}

void print_ears(const Rim& rim, const RimEvidence& e, const LocalSizes& sizes, const CornerHistogram& corners,
                const std::vector<int>& truth) {
  const std::vector<double> jagged = jaggedness(e.samples.points, rim);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Index a = rim[i], b = rim[(i + 1) % rim.size()];
    const Index behind = e.set.apex(selected_triangle(e.set, e.selection, a, b), a, b);
    if (jagged[i] == 0 || truth[behind] < 0) continue;
    const FalseEarMeasures x = measure_false_ear(e.set, sizes, corners, {a, behind, b}, jagged[i]);
    std::printf("ears,%d,%.6g,%.6g,%.6g\n", truth[behind], x.angle, x.log_tail, x.jaggedness);
  }
}

void print_points(const Rim& rim, const RimEvidence& e, const LocalSizes& sizes, const BoundaryScores& scores,
                  const std::vector<int>& truth, double probability) {
  const std::size_t n = rim.size();
  const auto at = [&](std::size_t i) { return rim[i % n]; };
  const auto print = [&](const char* term, Index v, const std::array<Index, 5>& ear) {
    if (truth[v] < 0) return;
    const double chi = scores.log_score[v];
    if (e.sampling.is_range_image) {
      if (term[7] == 'o') std::printf("range_points,%d,%.6g\n", truth[v], chi);
      return;
    }
    std::printf("%s,%d,%.6g,%.6g,%.6g\n", term, truth[v], ear_log_odds(e.set, sizes, {}, ear), chi,
                probability);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Index a = at(i), b = at(i + 1);
    print("points_on", a, {at(i + n - 2), at(i + n - 1), a, b, at(i + 2)});
    const Index inner = e.set.apex(selected_triangle(e.set, e.selection, a, b), a, b);
    print("points_behind", inner, {at(i + n - 1), a, inner, b, at(i + 2)});
  }
}

// The true loops by arranged points; none where there is no file of them.
std::vector<Rim> true_loops(const std::string& file, const Arrangement& arranged, std::size_t points) {
  if (!std::filesystem::exists(file)) return {};
  std::vector<Index> place(points, none);
  for (Index i = 0; i < arranged.ids.size(); ++i) place[arranged.ids[i]] = i;
  std::vector<Rim> loops;
  for (const Loop& loop : read_loops(file, points)) {
    Rim& rim = loops.emplace_back();
    for (const Index id : loop.points) {
      if (place[id] != none) rim.push_back(place[id]);
    }
  }
  return loops;
}

void run_on(const std::string& file) {
  const Run run;
  const BoundaryLoopOptions options;
  const Cloud cloud = read_cloud(file, run);
  const Arrangement arranged = arrange(cloud.points, run);
  const Points points = arranged.points;
  const std::vector<int> truth = truth_of(cloud, arranged);
  const Neighbours neighbours = find_neighbours(points, most_neighbours(Options{}), run);
  const std::vector<double> spacing = local_spacing(points, neighbours, run);
  const BoundaryScores scores = score_boundary(points, neighbours, {}, run);

  const auto image = find_range_image(points, neighbours, run);
  const auto sampling = image ? of_range_image() : profile_sampling(points, neighbours, spacing, run);
  const auto denoised = denoise(points, neighbours, sampling, run);
  const auto samples = denoised ? with_frames(denoised->points, denoised->neighbours, denoised->spacing, run)
                                : with_frames(points, neighbours, spacing, run);
  auto proposed =
      image ? range_image_triangles(samples.points, samples.frames, *image) : propose_surface(samples, run);
  const Selection all(proposed.size(), 1);
  print_rims({proposed, all, {}, samples, sampling}, truth, run);
  const auto surface = select(std::move(proposed), samples, sampling, options, run);
  const auto loops =
      true_loops(file.substr(0, file.rfind('.')) + ".loops.json", arranged, cloud.points.size());
  if (!image && !loops.empty()) print_triangles(surface, samples, sampling, loops, run);
  const LocalSizes sizes(surface.set, samples.neighbours, run);
  const auto without = remove_false_ears(surface, sizes, samples, sampling, options, run);

  const RimEvidence before{surface.set, surface.selection, {}, samples, sampling};
  for (const Rim& rim : walk_rims(surface.set, surface.selection, run)) {
    if (without.behind.empty() || static_cast<int>(rim.size()) < options.min_loop) continue;
    if (boundary_probability(rim, before, run) >= options.min_probability)
      print_ears(rim, before, sizes, without.corners, truth);
  }
  const RimEvidence after{surface.set, without.selection, without.behind, samples, sampling};
  for (const Rim& rim : walk_rims(surface.set, without.selection, run)) {
    const double p = boundary_probability(rim, after, run);
    if (p >= likely) print_points(rim, after, sizes, scores, truth, p);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: rimline_features SET.ply\n");
    return 1;
  }
  try {
    run_on(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
    return 2;
  }
  return 0;
}
