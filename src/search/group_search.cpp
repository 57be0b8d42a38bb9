// SPDX-License-Identifier: GPL-3.0-or-later
#include "search/group_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/model.h"

namespace rimline {
namespace {

constexpr double least_gain_of_flip = 1e-9;  // [guard]
constexpr std::uint32_t most_in_table = 8;   // bits of a vertex whose costs are tabulated [speed]

}  // namespace

void GroupSearch::start(const CandidateGroup& group) {
  const auto size = static_cast<std::uint32_t>(group.size());
  bits_.clear();
  pairs_.clear();
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t b = group[i];
    Bit& bit = bits_.emplace_back(Bit{.candidate = b,
                                      .triangle = candidates_.triangles[b],
                                      .gain = candidates_.gain[b],
                                      .contrast = candidates_.contrast[b]});
    std::array<std::uint32_t, 4>& near = bit.near;
    near[bit.near_count++] = i;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t other = candidates_.candidate_beside[b][k];
      if (other != not_candidate) {
        bit.beside[k] = groups_.place[other];
        near[bit.near_count++] = bit.beside[k];
      } else {
        bit.beside[k] = candidates_.beside[b][k] == none ? size : size + 1;
      }
      pairs_.push_back({candidates_.slots[b][k], i});
    }
    std::sort(near.begin(), near.begin() + bit.near_count);
    bit.near_count =
        static_cast<std::uint32_t>(std::unique(near.begin(), near.begin() + bit.near_count) - near.begin());
  }
  now_.assign(size + 2, 1);
  now_[size] = 0;
  settled_.assign(size, 0);
  stamp_.assign(size, 0);
  epoch_ = 0;
  find_vertices();
}

void GroupSearch::find_vertices() {
  std::sort(pairs_.begin(), pairs_.end());
  at_vertex_.clear();
  for (const auto& pair : pairs_) at_vertex_.push_back(pair.second);
  vertices_.clear();
  std::uint32_t costs = 0;
  const auto end = static_cast<std::uint32_t>(pairs_.size());
  for (std::uint32_t first = 0, last = 0; first < end; first = last) {
    while (last < end && pairs_[last].first == pairs_[first].first) ++last;
    const std::uint32_t here = last - first;
    const bool few = here <= most_in_table;
    const std::uint32_t slot = pairs_[first].first, id = static_cast<std::uint32_t>(vertices_.size());
    for (std::uint32_t k = first; k < last; ++k) {
      Bit& bit = bits_[at_vertex_[k]];
      bit.vertices[bit.found] = id;
      bit.places[bit.found++] = static_cast<std::uint8_t>(few ? k - first : 0);
      for (int c = 0; c < 3; ++c) {
        if (candidates_.slots[bit.candidate][c] == slot) bit.corners[c] = id;
      }
    }
    vertices_.push_back({slot, first, last, few ? costs : not_candidate, few ? (1u << here) - 1 : 0});
    if (few) costs += 1u << here;
  }
  // The order of a triangle's corners depends on ids, which change when the cloud is turned.
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return std::ranges::lexicographical_compare(bits_at(vertices_[a]), bits_at(vertices_[b]));
  };
  for (Bit& bit : bits_) std::sort(std::begin(bit.corners), std::end(bit.corners), before);
  near_.start(bits_.size());
  touched_.start(vertices_.size());
  costs_.assign(costs, std::numeric_limits<double>::quiet_NaN());
}

// Flips one bit.
void GroupSearch::turn(std::uint32_t i) {
  const Bit& bit = bits_[i];
  now_[i] ^= 1;
  selected_[bit.triangle] ^= 1;
  for (int k = 0; k < 3; ++k) vertices_[bit.vertices[k]].mask ^= 1u << bit.places[k];
}

// Cost of the rim at a vertex for the current bits.
double GroupSearch::cost(std::uint32_t v) {
  const Vertex& vertex = vertices_[v];
  const double even = candidates_.even.empty() ? 0 : candidates_.even[vertex.slot];
  const auto ask = [&] { return corners_.cost(vertex.slot, selected_, options_.weights, even); };
  if (vertex.costs == not_candidate) return ask();
  double& known = costs_[vertex.costs + vertex.mask];
  if (std::isnan(known)) known = ask();
  return known;
}

// Log odds of a triangle that is left out; 0 if it is selected.
double GroupSearch::worth(std::uint32_t i) const {
  if (now_[i]) return 0;
  const Bit& bit = bits_[i];
  double sum = bit.gain;
  for (int k = 0; k < 3; ++k) sum += now_[bit.beside[k]] * bit.contrast[k];
  return sum;
}

double GroupSearch::fitness() {
  double sum = 0;
  for (std::uint32_t i = 0; i < count(); ++i) sum += worth(i);
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) sum -= cost(v);
  return sum;
}

double GroupSearch::flip_one(std::uint32_t i) {
  const Bit& bit = bits_[i];
  double gain = 0;
  for (const std::uint32_t v : bit.vertices) gain += cost(v);
  for (std::uint32_t k = 0; k < bit.near_count; ++k) gain -= worth(bit.near[k]);
  turn(i);
  for (const std::uint32_t v : bit.vertices) gain -= cost(v);
  for (std::uint32_t k = 0; k < bit.near_count; ++k) gain += worth(bit.near[k]);
  return gain;
}

double GroupSearch::flip(std::span<const std::uint32_t> which) {
  if (which.size() == 1) return flip_one(which[0]);
  for (const std::uint32_t i : which) {
    const Bit& bit = bits_[i];
    for (const std::uint32_t v : bit.vertices) touched_.add(v);
    for (std::uint32_t k = 0; k < bit.near_count; ++k) near_.add(bit.near[k]);
  }
  double gain = 0;
  touched_.each([&](std::uint32_t v) { gain += cost(v); });
  near_.each([&](std::uint32_t i) { gain -= worth(i); });
  for (const std::uint32_t i : which) turn(i);
  touched_.each([&](std::uint32_t v) { gain -= cost(v); });
  near_.each([&](std::uint32_t i) { gain += worth(i); });
  touched_.clear();
  near_.clear();
  return gain;
}

// Flips the bits, and flips them back if that lowers the fitness. Returns the gain.
double GroupSearch::try_flip(std::span<const std::uint32_t> which) {
  const bool is_one = which.size() == 1;
  if (is_one && settled_[which[0]]) return 0;
  const double gain = flip(which);
  if (gain > least_gain_of_flip) {
    for (const std::uint32_t i : which) unsettle(i);
    return gain;
  }
  for (const std::uint32_t i : which) turn(i);
  if (is_one) settled_[which[0]] = 1;
  return 0;
}

// After a flip: marks as unsettled the bits that share a vertex with it, whose gains may have changed.
void GroupSearch::unsettle(std::uint32_t i) {
  for (const std::uint32_t v : bits_[i].corners) {
    for (const std::uint32_t other : bits_at(vertices_[v])) settled_[other] = 0;
  }
}

// A connected set of at most `most` bits around one, of bits for which take() is true.
template <class Take>
std::span<const std::uint32_t> GroupSearch::region(std::uint32_t from, std::size_t most, const Take& take) {
  region_.assign(1, from);
  ++epoch_;
  stamp_[from] = epoch_;
  for (std::size_t k = 0; k < region_.size() && region_.size() < most; ++k) {
    for (const std::uint32_t v : bits_[region_[k]].corners) {
      for (const std::uint32_t i : bits_at(vertices_[v])) {
        if (region_.size() >= most) break;
        if (stamp_[i] == epoch_ || !take(i)) continue;
        stamp_[i] = epoch_;
        region_.push_back(i);
      }
    }
  }
  return region_;
}

void GroupSearch::set(std::uint32_t i, bool value) {
  if ((now_[i] != 0) == value) return;
  turn(i);
  unsettle(i);
}

void GroupSearch::load(const Chromosome& genes) {
  for (std::uint32_t i = 0; i < count(); ++i) set(i, genes[i] != 0);
}

void GroupSearch::load_by_size(double threshold) {
  for (std::uint32_t i = 0; i < count(); ++i) set(i, candidates_.log_ratio[bits_[i].candidate] <= threshold);
}

// Hill climbing by flips of single bits.
void GroupSearch::climb() {
  double gain = 0, before = -1;
  for (int sweep = 0; sweep < 20 && gain > before; ++sweep) {  // [guard]
    before = gain;
    for (std::uint32_t i = 0; i < count(); ++i) gain += try_flip({&i, 1});
  }
}

void GroupSearch::first_population(std::size_t size) {
  members_.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    // Selections by thresholds on size, from large to small.
    const auto steps = static_cast<double>(std::max<std::size_t>(3, size) - 2);
    const double threshold =
        i == 0 ? model::population_all
               : model::population_first - model::population_range * static_cast<double>(i - 1) / steps;
    load_by_size(threshold);
    if (i > 0 && is_now(start_)) {
      members_[i] = members_[i - 1];
      continue;
    }
    store(start_);
    climb();
    store(members_[i].genes);
    members_[i].fitness = fitness();
  }
}

// One generation: each member tries connected regions of other members (crossover) and of its own (mutation).
void GroupSearch::breed() {
  for (Member& member : members_) {
    load(member.genes);
    const std::size_t crossings = 2 + bits_.size() / 4;
    for (std::size_t c = 0; c < crossings; ++c) {
      const Member& donor = members_[random_.below(members_.size())];
      const auto start = static_cast<std::uint32_t>(random_.below(bits_.size()));
      const auto differs = [&](std::uint32_t i) { return donor.genes[i] != now_[i]; };
      if (!differs(start)) continue;
      member.fitness +=
          try_flip(region(start, std::size_t{2} << random_.below(7), differs));  // [speed] up to 128 at once
    }
    const std::size_t mutations = 2 + bits_.size() / 4;
    for (std::size_t m = 0; m < mutations; ++m) {
      const auto start = static_cast<std::uint32_t>(random_.below(bits_.size()));
      const bool value = now_[start];
      member.fitness +=
          try_flip(region(start, 1 + random_.below(4), [&](std::uint32_t i) { return now_[i] == value; }));
    }
    store(member.genes);
  }
}

GroupResult GroupSearch::search(const CandidateGroup& group, const Random& random) {
  start(group);
  random_ = random;
  GroupResult result;
  load_by_size(model::greedy_size);
  result.greedy = fitness();
  if (options_.is_greedy) {
    result.best = result.greedy + close_doubtful_holes();
    return result;
  }
  first_population(std::min<std::size_t>(options_.population, 2 + 2 * bits_.size()));
  const auto better = [](const Member& a, const Member& b) { return a.fitness < b.fitness; };
  int stale = 0;
  for (int i = 0; i < options_.generations; ++i) {
    const bool agree = std::all_of(members_.begin(), members_.end(),
                                   [&](const Member& m) { return m.genes == members_[0].genes; });
    const bool goes_on = !agree && stale < 4;
    if (goes_on) breed();
    const double best = std::max_element(members_.begin(), members_.end(), better)->fitness;
    double mean = 0;
    for (const Member& m : members_) mean += m.fitness / members_.size();
    result.history_best.push_back(best);
    result.history_mean.push_back(mean);
    if (!goes_on) break;
    stale = mean > best - 1e-9 ? stale + 1 : 0;  // [guard]
  }
  const auto winner = std::max_element(members_.begin(), members_.end(), better);
  load(winner->genes);
  result.best = winner->fitness + close_doubtful_holes();
  return result;
}

// Closes holes inside the surface that chance explains: a hole must gain more than the best gap that chance
// tears somewhere on a surface of this size, and its empty disc must be twice the usual size. Returns the
// change of fitness.
double GroupSearch::close_doubtful_holes() {
  double change = 0;
  std::vector<std::uint8_t> seen(count(), 0);
  for (std::uint32_t i = 0; i < count(); ++i) {
    if (seen[i] || now_[i]) continue;
    const Hole hole = hole_at(i, seen);
    if (hole.outside) continue;
    const double gain = flip(hole.bits);
    if (hole.largest >= std::log(model::hole_least_size) && -gain >= least_gain(hole)) {
      for (const std::uint32_t bit : hole.bits) turn(bit);
    } else {
      change += gain;
    }
  }
  return change;
}

// The connected triangles left out around `start`.
GroupSearch::Hole GroupSearch::hole_at(std::uint32_t start, std::vector<std::uint8_t>& seen) const {
  Hole result;
  std::vector<std::uint32_t>& found = result.bits;
  found.push_back(start);
  seen[start] = 1;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Bit& bit = bits_[found[k]];
    result.spread += candidates_.spread[bit.candidate];
    result.largest = std::max(result.largest, candidates_.log_ratio[bit.candidate]);
    for (const std::uint32_t other : bit.beside) {
      if (other == count()) result.outside = true;
      if (now_[other] || other == count()) continue;
      if (!seen[other]) found.push_back(other);
      seen[other] = 1;
    }
  }
  result.spread /= static_cast<double>(found.size());
  return result;
}

// The least gain of a hole. It is higher where sizes spread, since chance tears holes there; but not for an
// empty disc that is too large for chance, and close to nothing for one far beyond all sizes around it.
double GroupSearch::least_gain(const Hole& hole) const {
  const FitnessWeights& w = options_.weights;
  if (is_far_beyond_spread(hole)) return w.hole_prior_beyond_spread;
  const double by_spread = is_chance(hole.largest) ? w.hole_prior_spread * hole.spread : 0;
  return w.hole_prior + by_spread + w.hole_prior_points * log_points_;
}

// Whether no size so large is expected among 2 n triangles with the spread around the hole. Logarithms of
// sizes are taken as normal, with a tail of exp(-z^2 / 2).
bool GroupSearch::is_far_beyond_spread(const Hole& hole) const {
  constexpr double to_deviation = model::spread_to_deviation;
  constexpr double usual = model::spread_usual;
  constexpr double margin = 4;  // e^-4 of them are expected
  const double z = (hole.largest - usual) / (to_deviation * hole.spread);
  return z * z / 2 - std::log(2 * model::prior_points) - log_points_ >= margin;
}

// Whether a triangle so large is expected among the 2 n of n random points. For random points the area of the
// circumcircle times the density follows Gamma(2), whose quantile at 5/8 is 2.15.
bool GroupSearch::is_chance(double log_ratio) const {
  constexpr double typical = model::chance_typical, margin = model::chance_margin;
  const double area = typical * std::exp(2 * log_ratio);
  return area - std::log1p(area) - std::log(2 * model::prior_points) - log_points_ < margin;
}

}  // namespace rimline
