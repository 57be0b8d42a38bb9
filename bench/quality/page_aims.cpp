// SPDX-License-Identifier: GPL-3.0-or-later
// What the default aims at, line by line, and whether this run reached it.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "quality/pages.h"
#include "quality/table.h"

namespace rimline::bench {
namespace {

class Aims {
 public:
  explicit Aims(const Results& results)
      : rows_(choose(results.rows, [](const Row& row) { return row.method == default_method; })) {}

  std::string markdown() const { return table_.markdown(); }

  // --- one line each ---------------------------------------------------------------------------------

  // All bounds hold on the set; loops_found in [least_loops, most_loops].
  struct SetAim {
    std::string set;
    std::vector<std::pair<const char*, double>> least;
    double least_loops = 0, most_loops = 1e9;
  };
  void set(const SetAim& aim) {
    const Row* row = set_row(aim.set);
    if (row == nullptr) return;
    std::string wanted, measured;
    bool met = true;
    for (const auto& [metric, bound] : aim.least) {
      const double value = get(*row, metric);
      met = met && value >= bound;
      append(wanted, fmt::format("{} {:g}", metric, bound));
      append(measured, fmt::format("{} {:.3f}", metric, value));
    }
    if (aim.least_loops > 0) {
      const double found = get(*row, "loops_found");
      met = met && found >= aim.least_loops && found <= aim.most_loops;
      append(wanted, aim.least_loops == aim.most_loops
                         ? fmt::format("loops {:g}", aim.least_loops)
                         : fmt::format("loops {:g} to {:g}", aim.least_loops, aim.most_loops));
      append(measured, fmt::format("loops {:g}", found));
    }
    add(aim.set, wanted, measured, met);
  }

  void mean_of_sets(const std::vector<std::string>& sets, const char* metric, double bound) {
    double sum = 0, count = 0;
    for (const std::string& name : sets) {
      if (const Row* row = set_row(name)) {
        sum += get(*row, metric);
        ++count;
      }
    }
    if (count < sets.size()) return;
    add(fmt::format("{}, mean", fmt::join(sets, ", ")), fmt::format("{} {:g}", metric, bound),
        fmt::format("{:.3f}", sum / count), sum / count >= bound);
  }

  // On every set whose loops are known: the length, simple, no crossing but where the truth has as many:
  // pieces of a raw scan lie over each other.
  void lengths() {
    std::string wrong;
    std::size_t sets = 0;
    for (const Row* row : rows_) {
      if (row->name.group != "data" || !row->loops.contains("length_error")) continue;
      ++sets;
      const double tolerance = row->name.shape.find("noisy") == std::string::npos ? 0.05 : 0.10;
      const bool good = get(*row, "length_error") <= tolerance && get(*row, "simple") == 1 &&
                        get(*row, "crossings") <= get(*row, "crossings_of_truth");
      if (!good) append(wrong, fmt::format("{} ({:.3f})", row->name.shape, get(*row, "length_over_truth")));
    }
    if (sets > 0) {
      add("every set with known loops",
          "length within 5 % (noise 10 %), simple, crossing no more often than the truth",
          wrong.empty() ? "all" : "not " + wrong, wrong.empty());
    }
  }

  // Mean over the sizes and shapes of a sampling and noise.
  void analytic(const std::string& what, const Choice& choice, const char* metric, double bound) {
    const Rows rows =
        choose(rows_, [&](const Row& row) { return row.name.group == "analytic" && choice(row); });
    const Summary s = summarize(rows, &Row::loops, metric);
    if (s.count == 0) return;
    add(what, fmt::format("{} {:g}", metric, bound), fmt::format("{:.4f} (worst {:.3f})", s.mean, s.least),
        s.mean >= bound);
  }

  void reliability() {
    Reliability sum;
    std::string wrong;
    for (const Row* row : rows_) {
      if (!row->reliability) continue;
      sum.add(*row->reliability);
      if (row->name.group != "data") continue;
      const double half = get(*row, "boundary_probability_half"), low = get(*row, "boundary_probability_low");
      if (half < 0.9 || low > 0.03)
        append(wrong, fmt::format("{} ({:.2f}, {:.2f})", row->name.shape, half, low));
    }
    if (sum.points() == 0) return;
    const auto share = [](const Reliability::Bin& b) { return b.points > 0 ? b.boundary / b.points : 0; };
    add("all points with truth", "of those given 0.9 or more, true: 0.9",
        fmt::format("{:.4f}", share(sum.bins[9])), share(sum.bins[9]) >= 0.9);
    add("all points with truth", "of those given less than 0.1, true: at most 0.01",
        fmt::format("{:.5f}", share(sum.bins[0])), share(sum.bins[0]) <= 0.01);
    add("all points with truth", "Brier score better than the best constant by 80 %",
        fmt::format("{:.1f} %", 100 * sum.gain()), sum.gain() >= 0.8);
    add("each set", "true boundary points: 0.9 have 0.5 or more, at most 0.03 less than 0.1",
        wrong.empty() ? "all" : "not " + wrong, wrong.empty());
  }

  void meshes() {
    const Rows sets =
        choose(rows_, [](const Row& r) { return r.name.group == "data" && r.mesh.contains("edges_agree"); });
    each_set(sets, "0 non-manifold edges and vertices, degenerate faces, conflicts", [](const Row& r) {
      return get_mesh(r, "nonmanifold_edges") + get_mesh(r, "nonmanifold_vertices") +
                 get_mesh(r, "degenerate_faces") + get_mesh(r, "orientation_conflicts") ==
             0;
    });
    each_set(sets, "Euler number and loops right (not bunny_scan)",
             [](const Row& r) { return r.name.shape == "bunny_scan" || get_mesh(r, "topology_right") == 1; });
    each_set(sets, "boundary edges are the loops",
             [](const Row& r) { return get_mesh(r, "boundary_is_loops") == 1; });
    const Rows judged = choose(sets, [](const Row& r) { return r.mesh.contains("edges_agree_flipped"); });
    each_set(judged, "edges_agree_flipped 0.90 (not bunny_scan)", [](const Row& r) {
      return r.name.shape == "bunny_scan" || get_mesh(r, "edges_agree_flipped") >= 0.90;
    });
    if (const Summary s = summarize(judged, &Row::mesh, "edges_agree_flipped"); s.count > 0) {
      add("sets with a truth mesh, mean", "edges_agree_flipped 0.95", number(s.mean), s.mean >= 0.95);
    }
    each_set(sets, "long edges at most 0.05 % more than the truth", [](const Row& r) {
      return get_mesh(r, "edges_longer_than_3_spacings") -
                 get_mesh(r, "edges_longer_than_3_spacings_in_truth") <=
             0.0005;
    });
    each_set(sets, "slivers at most 1 % more than the truth", [](const Row& r) {
      return get_mesh(r, "min_angle_below_10deg") - get_mesh(r, "min_angle_below_10deg_in_truth") <= 0.01;
    });
    each_set(sets, "uv flips 0", [](const Row& r) { return get_mesh(r, "uv_flipped_triangles") == 0; });
    each_set(sets, "no self-intersection where the truth has none", [](const Row& r) {
      return get_mesh(r, "self_intersections_in_truth") > 0 || get_mesh(r, "self_intersections") == 0;
    });
    each_set(sets, "rim points F1 0.9 (not bunny_scan and the three jagged cuts)", [](const Row& r) {
      return r.name.shape == "bunny_scan" || r.name.shape.rfind("isis_", 0) == 0 ||
             r.name.shape == "seahorse_side" || get_mesh(r, "boundary_points_f1") >= 0.9;
    });
    if (const Row* row = set_row("distcap"); row != nullptr && !row->mesh.empty()) {
      const double share = get_mesh(*row, "edges_longer_than_3_spacings", 1);
      add("distcap", "edges over 3 spacings below 0.1 %", fmt::format("{:.3f} %", 100 * share),
          share < 0.001);
    }
  }

  void soundness(const std::string& what, const Choice& choice) {
    const Rows rows = choose(rows_, [&](const Row& r) {
      return r.name.group == "analytic" && r.mesh.contains("sound") && choice(r);
    });
    if (rows.empty()) return;
    const Summary s = summarize(rows, &Row::mesh, "sound");
    add(what, "every mesh sound", fmt::format("{:.0f} of {}", s.mean * static_cast<double>(s.count), s.count),
        s.least == 1);
  }

  void verdicts() {
    const Rows rows = choose(rows_, [](const Row& r) { return r.name.group == "topology"; });
    const Summary s = summarize(rows, &Row::mesh, "verdict_right");
    if (s.count == 0) return;
    add("torus minus cap, Moebius strip, sphere, pipe", "Euler number and loops right in all",
        fmt::format("{:.0f} of {}", s.mean * static_cast<double>(s.count), s.count), s.least == 1);
  }

 private:
  static double get(const Row& row, const char* metric, double other = 0) {
    const auto found = row.loops.find(metric);
    return found == row.loops.end() ? other : found->second;
  }
  static double get_mesh(const Row& row, const char* metric, double other = -1) {
    const auto found = row.mesh.find(metric);
    return found == row.mesh.end() ? other : found->second;
  }
  // Two duplicate points pinch the outer loop of beetle: merged, its one outline is up to three.
  static bool has_right_topology(const Row& r) {
    const double loops = get_mesh(r, "boundary_loops");
    const bool pinched =
        r.name.shape == "beetle" && loops >= 11 && loops <= 13 && get_mesh(r, "euler") == 2 - loops;
    return r.name.shape == "bunny_scan" || get_mesh(r, "topology_right") == 1 || pinched;
  }
  static void append(std::string& list, const std::string& item) {
    list += (list.empty() ? "" : ", ") + item;
  }

  const Row* set_row(const std::string& set) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row* row) {
      return row->name.group == "data" && row->name.shape == set;
    });
    return found == rows_.end() ? nullptr : *found;
  }

  void each_set(const Rows& sets, const std::string& wanted, const Choice& holds) {
    if (sets.empty()) return;
    std::string wrong;
    for (const Row* row : sets) {
      if (!holds(*row)) append(wrong, row->name.shape);
    }
    add("each set with a truth mesh", wanted, wrong.empty() ? "all" : "not " + wrong, wrong.empty());
  }

  void add(const std::string& where, const std::string& wanted, const std::string& measured, bool met) {
    table_.add({where, wanted, measured, met ? "yes" : "**no**"});
  }

  Rows rows_;
  Table table_{{"where", "aim (at least, where not said)", "measured", "met"}};
};

constexpr const char* within = "points_f1_within_one_spacing";

void data_aims(Aims& aims) {
  for (const char* set : {"head", "mannequin", "mannequin_uniform", "mannequin_nonuniform", "bump_domain"}) {
    aims.set({set, {{"all_exact", 1}}, 1, 1});
  }
  aims.set({"st_helens", {{"edges_f1", 0.98}}});
  for (const char* set : {"camelhead", "mannequin_devil"}) {
    aims.set({set, {{"edges_f1", 0.90}, {within, 0.99}}, 1, 1});
  }
  aims.set({"beetle", {{"loops_exact", 8}, {"longest_within_1", 0.95}}, 11, 13});
  aims.set({"halftunnel", {{"loops_exact", 2}, {"loops_found_or_labelled", 3}}});
  for (const char* set : {"isis_open", "isis_front", "seahorse_side"})
    aims.set({set, {{within, 0.96}}, 1, 1});
  aims.mean_of_sets({"isis_open", "isis_front", "seahorse_side"}, "points_f1", 0.90);
  for (const char* set : {"mannequin_noisy", "head_1m"}) aims.set({set, {{within, 0.99}}, 1, 1});
  aims.set({"bunny_scan",
            {{"points_f1", 0.84},
             {within, 0.94},
             {"longest_within_1", 0.9},
             {"longest_within_2", 0.9},
             {"longest_within_3", 0.9},
             {"longest_within_4", 0.9}}});
  aims.lengths();
}

Choice sampled(std::vector<std::string> samplings, double noise) {
  return [=](const Row& row) {
    return row.name.noise == noise &&
           std::find(samplings.begin(), samplings.end(), row.name.sampling) != samplings.end();
  };
}

void analytic_aims(Aims& aims) {
  for (const char* sampling : {"blue-noise", "grid", "smooth-density", "density-step"}) {
    aims.analytic(sampling, sampled({sampling}, 0), "points_f1", 0.995);
  }
  aims.analytic("random", sampled({"random"}, 0), "points_f1", 0.97);
  aims.analytic("random, by probability", sampled({"random"}, 0), "probable_points_f1", 0.97);
  aims.analytic("random, the points of the loops alone", sampled({"random"}, 0), "rim_points_f1", 0.97);
  aims.analytic("blue-noise, noise 0.2", sampled({"blue-noise"}, 0.2), "points_f1", 0.98);
  aims.analytic("blue-noise, noise 0.5", sampled({"blue-noise"}, 0.5), "points_f1", 0.85);
  aims.analytic("blue-noise, noise 0.5", sampled({"blue-noise"}, 0.5), within, 0.97);
  aims.analytic("cropped", sampled({"cropped"}, 0), "points_f1", 0.88);
  aims.analytic("cropped", sampled({"cropped"}, 0), within, 0.98);
  aims.analytic(
      "all without noise", [](const Row& r) { return r.name.noise == 0; }, "loops_right", 0.99);
  aims.analytic(
      "all with noise 0.5", [](const Row& r) { return r.name.noise == 0.5; }, "loops_right", 0.90);
}

}  // namespace

std::string aims_section(const Results& results) {
  Aims aims(results);
  analytic_aims(aims);
  data_aims(aims);
  aims.reliability();
  aims.soundness("analytic, n 10000, no noise", [](const Row& r) { return r.name.noise == 0; });
  aims.soundness("analytic, n 10000, noise 0.2", [](const Row& r) { return r.name.noise == 0.2; });
  aims.meshes();
  aims.verdicts();
  return "\n## What the default aims at\n\n" + aims.markdown();
}

}  // namespace rimline::bench
