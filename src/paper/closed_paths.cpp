// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/closed_paths.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "base/parallel.h"
#include "base/random.h"
#include "paper/fitness.h"

namespace rimline {

ClosedPathSearcher::ClosedPathSearcher(const Neighbours& neighbours,
                                       const std::vector<std::uint8_t>& candidate, int path_k, int threshold)
    : neighbours_(neighbours),
      candidate_(candidate),
      path_k_(std::min(path_k, neighbours.k)),
      threshold_(threshold > 0 ? threshold : path_k + 1),
      passed_(candidate.size(), none),
      next_(candidate.size(), 0) {}

bool ClosedPathSearcher::closes(Index point, Index start) {
  const auto list = neighbours_.of(point, path_k_);
  steps_ += path_k_;
  return std::find(list.begin(), list.end(), start) != list.end();
}

std::vector<Index> ClosedPathSearcher::find(Index start) {
  ++mark_;
  std::vector<Index> path;
  const auto enter = [&](Index p) {  // the head of FIND_BOUNDARY_PATH(p, start)
    passed_[p] = mark_;
    next_[p] = 0;
    path.push_back(p);
    // The listing asks before p is counted: path.size() - 1 points are in the path so far.
    return path.size() - 1 >= threshold_ && closes(p, start);
  };
  if (enter(start)) return path;
  while (!path.empty()) {
    const Index p = path.back();
    const auto list = neighbours_.of(p, path_k_);
    bool deeper = false;
    while (next_[p] < path_k_ && !deeper) {
      const Index q = list[next_[p]++];
      ++steps_;
      if (!candidate_[q] || passed_[q] == mark_) continue;
      if (enter(q)) return path;
      deeper = true;
    }
    if (!deeper) path.pop_back();  // p.inBoundaryPath := false
  }
  return path;
}

namespace {

bool fitter(const ClosedPath& a, const ClosedPath& b) {
  if (a.log_fitness != b.log_fitness) return a.log_fitness > b.log_fitness;
  return a.ids < b.ids;
}

// A 64-bit hash of a set of ids, independent of their order.
std::uint64_t set_hash(const std::vector<Index>& ids) {
  std::uint64_t hash = ids.size();
  for (const Index id : ids) hash += Random(static_cast<std::uint64_t>(id)).next();
  return hash;
}

std::vector<Index> shuffled_candidates(const std::vector<std::uint8_t>& candidate, std::uint64_t seed) {
  std::vector<Index> starts;
  for (Index i = 0; i < static_cast<Index>(candidate.size()); ++i) {
    if (candidate[i]) starts.push_back(i);
  }
  Random(seed, 31).shuffle(starts);
  return starts;
}

// The fittest distinct paths so far. The hashes of all paths are kept, the paths are not: there may be as
// many as candidates, each as long.
class Shortlist {
 public:
  explicit Shortlist(std::size_t most) : most_(most) {}

  void add(ClosedPath path, std::uint64_t hash) {
    hashes_.push_back(hash);
    if (best_.size() == most_ && !fitter(path, best_.back())) return;
    const auto at = std::lower_bound(best_.begin(), best_.end(), path, fitter);
    if (at != best_.end() && at->ids == path.ids) return;
    best_.insert(at, std::move(path));
    if (best_.size() > most_) best_.pop_back();
  }
  std::size_t distinct() {
    std::sort(hashes_.begin(), hashes_.end());
    return std::unique(hashes_.begin(), hashes_.end()) - hashes_.begin();
  }
  std::vector<ClosedPath> take() { return std::move(best_); }

 private:
  std::size_t most_;
  std::vector<ClosedPath> best_;
  std::vector<std::uint64_t> hashes_;
};

}  // namespace

ClosedPaths find_closed_paths(const Neighbours& neighbours, const BoundaryScores& scores,
                              const LoopOptions& options, const Run& run) {
  // Starts between two looks at the bound: a fixed number, so that the bound does not depend on threads.
  constexpr std::size_t batch = 64;
  const std::vector<Index> starts = shuffled_candidates(scores.candidate, run.seed);
  tbb::enumerable_thread_specific<ClosedPathSearcher> searchers([&] {
    return ClosedPathSearcher(neighbours, scores.candidate, options.path_k, options.path_threshold);
  });
  Arena arena(run);
  Shortlist shortlist(options.population);
  ClosedPaths result;
  std::vector<ClosedPath> found(batch);
  std::vector<std::uint64_t> hashes(batch);
  while (result.starts < starts.size() && result.steps < options.max_path_steps) {
    run.progress(Stage::Loops, result.starts, starts.size());
    const std::size_t count = std::min(batch, starts.size() - result.starts);
    arena.execute([&] {
      run_tasks(count, [&](std::size_t i) {
        ClosedPath& path = found[i];
        path.ids = run.cancelled() ? std::vector<Index>{} : searchers.local().find(starts[result.starts + i]);
        std::sort(path.ids.begin(), path.ids.end());
        path.log_fitness = log_fitness(path.ids, scores, options);
        hashes[i] = set_hash(path.ids);
      });
    });
    run.check_cancel();
    for (std::size_t i = 0; i < count; ++i) {
      if (found[i].ids.empty()) continue;
      ++result.closed;
      shortlist.add(std::move(found[i]), hashes[i]);
    }
    result.starts += count;
    result.steps = 0;
    for (const ClosedPathSearcher& searcher : searchers) result.steps += searcher.steps();
  }
  result.bound_hit = result.starts < starts.size();
  result.distinct = shortlist.distinct();
  result.best = shortlist.take();
  return result;
}

}  // namespace rimline
