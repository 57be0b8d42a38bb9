// SPDX-License-Identifier: GPL-3.0-or-later
// After section 3 of Maes & Bultheel 2004; the simple genetic algorithm is that of Whitley, "A genetic
// algorithm tutorial", Statistics and Computing 4, 1994.
#include "paper/genetic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "paper/fitness.h"

namespace rimline {

std::vector<Index> Chromosome::ids() const {
  std::vector<Index> result;
  for (std::size_t w = 0; w < words_.size(); ++w) {
    for (std::uint64_t rest = words_[w]; rest != 0; rest &= rest - 1) {
      result.push_back(static_cast<Index>(64 * w + std::countr_zero(rest)));
    }
  }
  return result;
}

void Chromosome::exchange_tails(Chromosome& a, Chromosome& b, std::size_t first) {
  const std::size_t whole = first / 64 + 1;
  const std::uint64_t tail = ~std::uint64_t{0} << (first % 64);
  const std::uint64_t differing = (a.words_[first / 64] ^ b.words_[first / 64]) & tail;
  a.words_[first / 64] ^= differing;
  b.words_[first / 64] ^= differing;
  std::swap_ranges(a.words_.begin() + whole, a.words_.end(), b.words_.begin() + whole);
}

namespace {

struct Member {
  Chromosome chromosome;
  double log_fitness;
};

// Selects members with probability proportional to their fitness. Logarithms are relative to the best, so
// that the printed score of eq. (2) can not overflow.
class Roulette {
 public:
  explicit Roulette(const std::vector<Member>& members) {
    double best = -std::numeric_limits<double>::infinity();
    for (const Member& m : members) best = std::max(best, m.log_fitness);
    double sum = 0;
    for (const Member& m : members) cumulative_.push_back(sum += std::exp(m.log_fitness - best));
  }
  std::size_t spin(Random& random) const {
    const double at = random.uniform() * cumulative_.back();
    const auto slot = std::upper_bound(cumulative_.begin(), cumulative_.end(), at);
    return std::min<std::size_t>(slot - cumulative_.begin(), cumulative_.size() - 1);
  }

 private:
  std::vector<double> cumulative_;
};

// Number of bits until the next mutation, by the geometric distribution: unchanged bits are skipped.
std::size_t mutation_gap(double probability, Random& random) {
  if (probability >= 1) return 0;
  const double gap = std::floor(std::log(1 - random.uniform()) / std::log1p(-probability));
  return gap < 1e15 ? static_cast<std::size_t>(gap) : std::size_t{1} << 50;
}

void mutate(Chromosome& chromosome, const std::vector<Index>& candidates, double probability,
            Random& random) {
  if (probability <= 0) return;
  for (std::size_t at = mutation_gap(probability, random); at < candidates.size();
       at += 1 + mutation_gap(probability, random)) {
    chromosome.flip(candidates[at]);
  }
}

std::vector<Member> next_population(const std::vector<Member>& members, std::size_t length,
                                    const std::vector<Index>& candidates, double mutation_probability,
                                    Random& random) {
  const Roulette roulette(members);
  std::vector<Member> next;
  for (std::size_t i = 0; i < members.size(); ++i) next.push_back(members[roulette.spin(random)]);
  // The selected members are in random order: consecutive ones are random pairs.
  for (std::size_t i = 0; i + 1 < next.size(); i += 2) {
    Chromosome::exchange_tails(next[i].chromosome, next[i + 1].chromosome, random.below(length));
  }
  for (Member& m : next) mutate(m.chromosome, candidates, mutation_probability, random);
  return next;
}

double saturated_exp(double x) { return std::min(std::exp(x), std::numeric_limits<double>::max()); }

// Reports a generation; the first of equal ones is the best.
void record(const std::vector<Member>& members, Evolution& result) {
  const auto best = std::max_element(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return a.log_fitness < b.log_fitness;
  });
  double sum = 0;  // relative to the best
  for (const Member& m : members) sum += std::exp(m.log_fitness - best->log_fitness);
  const double mean = best->log_fitness + std::log(sum / static_cast<double>(members.size()));
  const auto generation = static_cast<int>(result.history.size());
  result.history.push_back({saturated_exp(best->log_fitness), saturated_exp(mean)});
  result.best.add({generation, saturated_exp(best->log_fitness), best->chromosome.ids()});
}

// Inserts new members among the fittest.
void keep_fittest(std::vector<ClosedPath>& fittest, const std::vector<Member>& members, std::size_t most) {
  const auto fitter = [](const ClosedPath& a, const ClosedPath& b) {
    return a.log_fitness != b.log_fitness ? a.log_fitness > b.log_fitness : a.ids < b.ids;
  };
  for (const Member& m : members) {
    if (fittest.size() >= most && m.log_fitness <= fittest.back().log_fitness) continue;
    ClosedPath path{m.chromosome.ids(), m.log_fitness};
    const auto at = std::lower_bound(fittest.begin(), fittest.end(), path, fitter);
    if (at != fittest.end() && at->ids == path.ids) continue;
    fittest.insert(at, std::move(path));
    if (fittest.size() > most) fittest.pop_back();
  }
}

}  // namespace

Evolution evolve(const std::vector<ClosedPath>& initial, const BoundaryScores& scores,
                 const LoopOptions& options, const Run& run) {
  const std::size_t length = scores.candidate.size();
  std::vector<Index> candidates;
  for (Index i = 0; i < static_cast<Index>(length); ++i) {
    if (scores.candidate[i]) candidates.push_back(i);
  }
  Evolution result{initial, {}, {}};
  std::vector<Member> members;
  for (const ClosedPath& path : initial) members.push_back({Chromosome(length, path.ids), path.log_fitness});
  if (members.empty()) return result;
  record(members, result);
  Random random(run.seed, 32);
  for (int generation = 0; generation < options.generations; ++generation) {
    run.check_cancel();
    members = next_population(members, length, candidates, options.mutation_probability, random);
    for (Member& m : members) m.log_fitness = log_fitness(m.chromosome.ids(), scores, options);
    record(members, result);
    keep_fittest(result.fittest, members, options.population);
  }
  return result;
}

}  // namespace rimline
