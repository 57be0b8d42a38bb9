// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rim_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel.h"
#include "random.h"
#include "union_find.h"

namespace rimline::exact {
namespace {

constexpr std::uint32_t certain = ~std::uint32_t{0};

// The doubtful triangles, and how they hang together.
struct Doubt {
  std::vector<Index> triangles;         // ascending
  std::vector<double> gain;             // of leaving each out, before corners are looked at
  std::vector<std::uint8_t> oversized;  // the choice by size alone: left out
  std::vector<double> log_ratio, own, spread;
  std::vector<std::array<Index, 3>> beside;                   // the triangles across its edges, or none
  std::vector<std::array<std::uint32_t, 3>> doubtful_beside;  // of those the positions here, or `certain`
  std::vector<std::array<double, 3>> contrast;  // worth of a rim between it, left out, and each of them, kept
  std::vector<Index> vertices;                  // of these triangles, ascending
  std::vector<std::array<std::uint32_t, 3>> slots;  // position of each triangle's vertices in `vertices`
};

constexpr double far_from_usual = 0.35;  // log_ratio beyond the spread that lets a hole start inside

// log_ratio beyond the spread of a triangle that closes an opening, whatever the gaps beside it are: a chord
// over a small hole leaves gaps that look like those at creases, since its other rim lies beyond them.
constexpr double plainly_too_large = 0.8;

// Whether a triangle is larger than the smallest in the stars of its corners by so much that all around it
// have to be asked. Most are not.
std::vector<std::uint8_t> large_triangles(const Complex& complex, const Run& run) {
  std::vector<double> least(complex.vertices(), 1e300);
  parallel_for_each(complex.vertices(), Stage::Loops, run, [&](Index v) {
    for (const Index t : complex.star(v)) least[v] = std::min(least[v], complex.radius(t));
  });
  std::vector<std::uint8_t> large(complex.size());
  parallel_for_each(complex.size(), Stage::Loops, run, [&](Index t) {
    double mean = 0;
    for (const Index v : complex.triangle(t)) mean += least[v] / 3;
    large[t] = complex.radius(t) >= 1.4 * mean;
  });
  return large;
}

// Whether a triangle is out of doubt for the gaps at its corners.
class Spared {
 public:
  Spared(const std::vector<std::uint8_t>& barred, LocalSizes& sizes) : barred_(barred), sizes_(sizes) {}

  bool may_be(const Triangle& x) const { return barred_[x[0]] || barred_[x[1]] || barred_[x[2]]; }
  bool operator()(const Triangle& x) const {
    if (std::any_of(x.begin(), x.end(), [&](Index v) { return barred_[v] == at_fold; })) return true;
    return may_be(x) && sizes_.log_ratio(x) <= plainly_too_large + sizes_.spread(x);
  }

 private:
  const std::vector<std::uint8_t>& barred_;
  LocalSizes& sizes_;
};

// The triangles that doubt starts from, ascending.
std::vector<Index> first_doubts(const Complex& complex, LocalSizes& sizes, const Spared& is_spared,
                                double doubtful, const Run& run) {
  std::vector<std::uint8_t> asked = large_triangles(complex, run);
  parallel_for_each(complex.size(), Stage::Loops, run, [&](Index t) {
    asked[t] = asked[t] || (complex.is_at_rim(t) && !is_spared.may_be(complex.triangle(t)));
  });
  const auto has_asked = [&](Index v) {
    const auto star = complex.star(v);
    return std::any_of(star.begin(), star.end(), [&](Index t) { return asked[t]; });
  };
  // Among random points most are asked, and bounds tell that most of these are nothing unusual.
  sizes.find_bounds(has_asked, run);
  parallel_for_each(complex.size(), Stage::Loops, run, [&](Index t) {
    asked[t] = asked[t] && (complex.is_at_rim(t) || sizes.may_exceed(t, far_from_usual));
  });
  sizes.find(has_asked, run);
  return parallel_gather<Index>(complex.size(), Stage::Loops, run, [&](Index t, std::vector<Index>& found) {
    if (!asked[t]) return;
    const Triangle& x = complex.triangle(t);
    if (is_spared(x)) return;
    const double ratio = sizes.log_ratio(x);  // all sizes it needs are known
    if (complex.is_at_rim(t) ? ratio > doubtful : ratio > far_from_usual + sizes.spread(x))
      found.push_back(t);
  });
}

std::vector<Index> doubtful_triangles(const Complex& complex, LocalSizes& sizes,
                                      const std::vector<std::uint8_t>& barred, double doubtful,
                                      const Run& run) {
  const Spared is_spared(barred, sizes);
  constexpr int deepest = 12;  // triangles from the rim
  std::vector<Index> queue = first_doubts(complex, sizes, is_spared, doubtful, run);
  std::vector<std::uint8_t> depth(complex.size(), 0);
  for (const Index t : queue) depth[t] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index t = queue[i];
    if (depth[t] >= deepest) continue;
    for (int k = 0; k < 3; ++k) {
      const Index other = complex.across(t, k);
      if (other == none || depth[other] || is_spared(complex.triangle(other)) ||
          sizes.log_ratio(complex.triangle(other)) <= doubtful)
        continue;
      depth[other] = static_cast<std::uint8_t>(depth[t] + 1);
      queue.push_back(other);
    }
  }
  std::sort(queue.begin(), queue.end());
  return queue;
}

// The vertices of the triangles, ascending.
std::vector<Index> vertices_of(const Complex& complex, const std::vector<Index>& triangles) {
  std::vector<Index> vertices;
  vertices.reserve(3 * triangles.size());
  for (const Index t : triangles) {
    for (const Index v : complex.triangle(t)) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// The position of an id among ascending ones, or `certain` where it is not among them.
std::uint32_t position(const std::vector<Index>& ids, Index id) {
  const auto at = std::lower_bound(ids.begin(), ids.end(), id);
  return at != ids.end() && *at == id ? static_cast<std::uint32_t>(at - ids.begin()) : certain;
}

Doubt collect(const Complex& complex, LocalSizes& sizes, const std::vector<std::uint8_t>& barred,
              const KnownRims& known, const RimSearchOptions& options, const Run& run) {
  const std::vector<double>& evenness = known.evenness;
  Doubt doubt;
  const RimWeights& w = options.weights;
  doubt.triangles =
      known.kept.empty() ? doubtful_triangles(complex, sizes, barred, options.doubtful, run) : known.doubts;
  doubt.vertices = vertices_of(complex, doubt.triangles);
  sizes.find(doubt.vertices, run);
  const std::size_t count = doubt.triangles.size();
  for (std::vector<double>* values : {&doubt.log_ratio, &doubt.own, &doubt.spread, &doubt.gain})
    values->resize(count);
  doubt.beside.resize(count);
  doubt.doubtful_beside.resize(count);
  doubt.contrast.resize(count);
  doubt.slots.resize(count);
  parallel_for_each(count, Stage::Loops, run, [&](Index i) {
    const Index t = doubt.triangles[i];
    const Triangle& x = complex.triangle(t);
    double largest = 0, even = 0;
    for (const Index v : x) {
      largest = std::max(largest, sizes.own(v));
      even += evenness.empty() ? 0 : evenness[v] / 3;
    }
    doubt.log_ratio[i] = sizes.log_ratio(x);
    doubt.own[i] = std::clamp(std::log(complex.radius(t) / largest), -1.0, 3.0);
    doubt.spread[i] = sizes.spread(x);
    doubt.gain[i] = w.open + w.size * doubt.log_ratio[i] + w.own * doubt.own[i] - w.even * even;
    for (int k = 0; k < 3; ++k) {
      const Index a = x[k], b = x[(k + 1) % 3], beside = complex.across(t, k);
      doubt.slots[i][k] = position(doubt.vertices, x[k]);
      doubt.beside[i][k] = beside;
      doubt.doubtful_beside[i][k] = beside == none ? certain : position(doubt.triangles, beside);
      doubt.contrast[i][k] = 0;
      if (beside == none) continue;
      const double own = std::max(sizes.own(complex.apex(beside, a, b)), complex.radius(beside));
      const double c = std::log(complex.radius(t) / own);
      doubt.contrast[i][k] = w.contrast * std::clamp(c - w.least_contrast, -1.0, 0.0);
    }
  });
  return doubt;
}

using Group = std::vector<std::uint32_t>;  // positions in Doubt::triangles

std::vector<Group> group(const Doubt& doubt) {
  UnionFind sets(doubt.vertices.size());
  for (const auto& s : doubt.slots) {
    sets.join(s[0], s[1]);
    sets.join(s[0], s[2]);
  }
  std::vector<Group> groups;
  std::vector<Index> group_of(doubt.vertices.size(), none);
  for (std::uint32_t i = 0; i < doubt.slots.size(); ++i) {
    Index& g = group_of[sets.find(doubt.slots[i][0])];
    if (g == none) {
      g = static_cast<Index>(groups.size());
      groups.emplace_back();
    }
    groups[g].push_back(i);
  }
  return groups;
}

using Chromosome = std::vector<std::uint8_t>;

// The search in one group. The shared mask `kept` holds the chromosome that is worked on.
class GroupSearch {
 public:
  GroupSearch(const Doubt& doubt, const Corners& corners, const Group& bits, const RimWeights& weights,
              Kept& kept, double log_points, Random random)
      : doubt_(doubt),
        corners_(corners),
        bits_(bits),
        weights_(weights),
        kept_(kept),
        log_points_(log_points),
        random_(random) {
    for (std::uint32_t i = 0; i < bits_.size(); ++i) {
      for (const std::uint32_t s : doubt_.slots[bits_[i]]) at_vertex_.push_back({s, i});
    }
    std::sort(at_vertex_.begin(), at_vertex_.end());
    stamp_.assign(bits_.size(), 0);
  }

  struct Member {
    Chromosome genes;
    double fitness;
  };

  void load(const Chromosome& genes) {
    for (std::size_t i = 0; i < bits_.size(); ++i) kept_[doubt_.triangles[bits_[i]]] = genes[i];
  }
  Chromosome store() const {
    Chromosome genes(bits_.size());
    for (std::size_t i = 0; i < bits_.size(); ++i) genes[i] = kept_[doubt_.triangles[bits_[i]]];
    return genes;
  }
  double fitness_now() const {
    double sum = 0;
    for (const std::uint32_t b : bits_) sum += worth(b);
    std::uint32_t last = ~0u;
    for (const auto& [slot, bit] : at_vertex_) {
      if (slot != last) sum -= corners_.cost(slot, kept_, weights_);
      last = slot;
    }
    return sum;
  }
  Chromosome by_size(double threshold) const {
    Chromosome genes(bits_.size());
    for (std::size_t i = 0; i < bits_.size(); ++i) genes[i] = doubt_.log_ratio[bits_[i]] <= threshold;
    return genes;
  }

  // What leaving a triangle out brings, where it is left out.
  double worth(std::uint32_t b) const {
    if (kept_[doubt_.triangles[b]]) return 0;
    double sum = doubt_.gain[b];
    for (int k = 0; k < 3; ++k) {
      const Index other = doubt_.beside[b][k];
      if (other != none && kept_[other]) sum += doubt_.contrast[b][k];
    }
    return sum;
  }

  // Flips the bits, and back again where that makes it worse. Returns the gain.
  double try_flip(const std::vector<std::uint32_t>& which) {
    const double gain = flip(which);
    if (gain > 1e-9) return gain;
    for (const std::uint32_t i : which) kept_[doubt_.triangles[bits_[i]]] ^= 1;
    return 0;
  }

  // Flips the bits and returns what the fitness gains.
  double flip(const std::vector<std::uint32_t>& which) {
    touched_.clear();
    for (const std::uint32_t i : which) {
      for (const std::uint32_t s : doubt_.slots[bits_[i]]) touched_.push_back(s);
    }
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    near_.clear();
    for (const std::uint32_t i : which) {
      near_.push_back(bits_[i]);
      for (const std::uint32_t other : doubt_.doubtful_beside[bits_[i]]) {
        if (other != certain) near_.push_back(other);
      }
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    double gain = 0;
    for (const std::uint32_t s : touched_) gain += corners_.cost(s, kept_, weights_);
    for (const std::uint32_t b : near_) gain -= worth(b);
    for (const std::uint32_t i : which) kept_[doubt_.triangles[bits_[i]]] ^= 1;
    for (const std::uint32_t s : touched_) gain -= corners_.cost(s, kept_, weights_);
    for (const std::uint32_t b : near_) gain += worth(b);
    return gain;
  }

  // A connected set of up to `most` bits around a random one; those for which take() says yes.
  template <class Take>
  std::vector<std::uint32_t> region(std::uint32_t start, std::size_t most, const Take& take) {
    std::vector<std::uint32_t> found{start};
    ++epoch_;
    stamp_[start] = epoch_;
    for (std::size_t k = 0; k < found.size() && found.size() < most; ++k) {
      for (const std::uint32_t s : doubt_.slots[bits_[found[k]]]) {
        auto at = std::lower_bound(at_vertex_.begin(), at_vertex_.end(), std::pair(s, 0u));
        for (; at != at_vertex_.end() && at->first == s && found.size() < most; ++at) {
          if (stamp_[at->second] == epoch_ || !take(at->second)) continue;
          stamp_[at->second] = epoch_;
          found.push_back(at->second);
        }
      }
    }
    return found;
  }

  double climb() {
    double gain = 0, before = -1;
    for (int sweep = 0; sweep < 20 && gain > before; ++sweep) {
      before = gain;
      for (std::uint32_t i = 0; i < bits_.size(); ++i) gain += try_flip({i});
    }
    return gain;
  }

  std::vector<Member> first_population(int size) {
    std::vector<Member> members;
    for (int i = 0; i < size; ++i) {
      // From all kept, over ever smaller sizes.
      const double threshold = i == 0 ? 10 : 1.6 - 1.5 * (i - 1) / std::max(1, size - 2);
      load(by_size(threshold));
      climb();
      members.push_back({store(), fitness_now()});
    }
    return members;
  }

  // One generation: every member takes over what improves it from others, and tries small changes.
  void breed(std::vector<Member>& members) {
    for (Member& member : members) {
      load(member.genes);
      const std::size_t crossings = 2 + bits_.size() / 4;
      for (std::size_t c = 0; c < crossings; ++c) {
        const Member& donor = members[random_.below(members.size())];
        const std::uint32_t start = static_cast<std::uint32_t>(random_.below(bits_.size()));
        const auto differs = [&](std::uint32_t i) {
          return donor.genes[i] != kept_[doubt_.triangles[bits_[i]]];
        };
        if (!differs(start)) continue;
        member.fitness += try_flip(region(start, std::size_t{2} << random_.below(7), differs));
      }
      const std::size_t mutations = 2 + bits_.size() / 4;
      for (std::size_t m = 0; m < mutations; ++m) {
        const std::uint32_t start = static_cast<std::uint32_t>(random_.below(bits_.size()));
        const bool value = kept_[doubt_.triangles[bits_[start]]];
        member.fitness += try_flip(region(start, 1 + random_.below(4), [&](std::uint32_t i) {
          return kept_[doubt_.triangles[bits_[i]]] == value;
        }));
      }
      member.genes = store();
    }
  }

  // Inside the surface a hole must be worth more than chance brings about somewhere on a large surface, and
  // its empty disc be twice as large as is usual; the others are closed. Returns what that changes the fitness
  // by.
  double close_doubtful_holes() {
    double change = 0;
    std::vector<std::uint8_t> seen(bits_.size(), 0);
    for (std::uint32_t i = 0; i < bits_.size(); ++i) {
      if (seen[i] || kept_[doubt_.triangles[bits_[i]]]) continue;
      const Void hole = void_at(i, seen);
      if (hole.outside) continue;
      const double gain = flip(hole.bits);
      if (hole.largest >= std::log(2.0) && -gain >= least_gain(hole)) {
        flip(hole.bits);
      } else {
        change += gain;
      }
    }
    return change;
  }

 private:
  // Left out triangles that hang together over edges.
  struct Void {
    std::vector<std::uint32_t> bits;
    bool outside = false;     // reaches a free edge of the complex
    double spread = 0;        // mean over the triangles
    double largest = -1e300;  // log_ratio
  };

  // The void that holds one.
  Void void_at(std::uint32_t start, std::vector<std::uint8_t>& seen) const {
    Void result;
    std::vector<std::uint32_t>& found = result.bits;
    found.push_back(start);
    seen[start] = 1;
    for (std::size_t k = 0; k < found.size(); ++k) {
      result.spread += doubt_.spread[bits_[found[k]]];
      result.largest = std::max(result.largest, doubt_.log_ratio[bits_[found[k]]]);
      for (const Index other : doubt_.beside[bits_[found[k]]]) {
        if (other == none) {
          result.outside = true;
        } else if (!kept_[other]) {
          const auto at = std::lower_bound(bits_.begin(), bits_.end(), other,
                                           [&](std::uint32_t b, Index t) { return doubt_.triangles[b] < t; });
          const auto position = static_cast<std::uint32_t>(at - bits_.begin());
          if (!seen[position]) found.push_back(position);
          seen[position] = 1;
        }
      }
    }
    result.spread /= static_cast<double>(found.size());
    return result;
  }

  // What a hole must bring. Where sizes spread, chance tears holes, and more is asked; but not of one whose
  // empty disc chance does not bring about.
  double least_gain(const Void& hole) const {
    const double by_spread = is_chance(hole.largest) ? weights_.birth_spread * hole.spread : 0;
    return weights_.birth + by_spread + weights_.birth_points * log_points_;
  }

  // Whether a triangle so large may be found among the 2 n of n random points. Of random points the area of
  // the circumcircle times the density has the law of Gamma(2), whose value 5/8 up is 2.15.
  bool is_chance(double log_ratio) const {
    constexpr double typical = 2.15, margin = 8;  // e^-8: the density is not known well
    const double area = typical * std::exp(2 * log_ratio);
    return area - std::log1p(area) - std::log(2000.0) - log_points_ < margin;
  }

  const Doubt& doubt_;
  const Corners& corners_;
  const Group& bits_;
  const RimWeights& weights_;
  Kept& kept_;
  double log_points_;
  Random random_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> at_vertex_;
  std::vector<std::uint32_t> touched_, near_, stamp_;
  std::uint32_t epoch_ = 0;
};

// What the search of one group finds, but for the triangles that it keeps.
struct GroupResult {
  double greedy = 0, best = 0;
  std::vector<double> history_best, history_mean;  // until it stopped; its last generation goes on
};

GroupResult search_group(GroupSearch& search, std::size_t bits, const RimSearchOptions& options) {
  GroupResult result;
  search.load(search.by_size(0.8));
  result.greedy = search.fitness_now();
  if (options.generations == 0) return result;
  auto members = search.first_population(std::min<int>(options.population, 2 + 2 * bits));
  const auto better = [](const auto& a, const auto& b) { return a.fitness < b.fitness; };
  int stale = 0;
  for (int i = 0; i < options.generations; ++i) {
    const bool agree = std::all_of(members.begin(), members.end(),
                                   [&](const auto& m) { return m.genes == members[0].genes; });
    const bool goes_on = !agree && stale < 4;
    if (goes_on) search.breed(members);
    const double best = std::max_element(members.begin(), members.end(), better)->fitness;
    double mean = 0;
    for (const auto& m : members) mean += m.fitness / members.size();
    result.history_best.push_back(best);
    result.history_mean.push_back(mean);
    if (!goes_on) break;
    stale = mean > best - 1e-9 ? stale + 1 : 0;
  }
  auto winner = std::max_element(members.begin(), members.end(), better);
  search.load(winner->genes);
  result.best = winner->fitness + search.close_doubtful_holes();
  return result;
}

// Where no rim is even the search would find what it found before.
bool take_over(const KnownRims& known, const Doubt& doubt, const Group& group, Kept& kept) {
  if (known.kept.empty()) return false;
  for (const std::uint32_t i : group) {
    for (const std::uint32_t s : doubt.slots[i]) {
      if (known.evenness[doubt.vertices[s]] > 0) return false;
    }
  }
  for (const std::uint32_t i : group) kept[doubt.triangles[i]] = known.kept[doubt.triangles[i]];
  return true;
}

}  // namespace

RimSearchResult search_rim(const Complex& complex, LocalSizes& sizes, const std::vector<std::uint8_t>& barred,
                           const KnownRims& known, const RimSearchOptions& options, const Run& run) {
  RimSearchResult result;
  result.kept.assign(complex.size(), 1);
  const Doubt doubt = collect(complex, sizes, barred, known, options, run);
  const Corners corners(complex, doubt.vertices, run);
  const std::vector<Group> groups = group(doubt);
  result.doubts = doubt.triangles;
  result.groups = groups.size();
  result.history_best.assign(options.generations, 0);
  result.history_mean.assign(options.generations, 0);
  const double log_points = std::max(0.0, std::log(complex.vertices() / 1000.0));
  // Groups share no vertex: none reads a byte of `kept` that another writes.
  std::vector<GroupResult> found(groups.size());
  parallel_tasks(groups.size(), Stage::Loops, run, [&](std::size_t g) {
    if (take_over(known, doubt, groups[g], result.kept)) return;
    GroupSearch search(doubt, corners, groups[g], options.weights, result.kept, log_points,
                       Random(run.seed, doubt.triangles[groups[g][0]]));
    found[g] = search_group(search, groups[g].size(), options);
  });
  run.check_cancel();
  for (const GroupResult& g : found) {
    if (options.generations > 0 && g.history_best.empty()) continue;  // taken over
    result.greedy += g.greedy;
    result.best += g.best;
    for (std::size_t i = 0; i < result.history_best.size(); ++i) {
      const std::size_t last = std::min(i, g.history_best.size() - 1);
      result.history_best[i] += g.history_best[last];
      result.history_mean[i] += g.history_mean[last];
    }
  }
  return result;
}

}  // namespace rimline::exact
