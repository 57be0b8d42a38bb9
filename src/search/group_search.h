// SPDX-License-Identifier: GPL-3.0-or-later
// The genetic search in one group of candidate triangles.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/random.h"
#include "search/fitness.h"
#include "search/groups.h"
#include "search/search_options.h"
#include "surface/rims.h"

namespace rimline {

// A set of small numbers, read in ascending order.
class Marks {
 public:
  // Of numbers below `count`.
  void start(std::size_t count) {
    words_.assign((count + 63) / 64, 0);  // [layout]
    begin_ = words_.size();
    end_ = 0;
  }
  void add(std::uint32_t i) {
    const std::size_t word = i / 64;             // [layout]
    words_[word] |= std::uint64_t{1} << i % 64;  // [layout]
    begin_ = std::min(begin_, word);
    end_ = std::max(end_, word + 1);
  }
  template <class Body>
  void each(const Body& body) const {
    for (std::size_t w = begin_; w < end_; ++w) {
      for (std::uint64_t left = words_[w]; left != 0; left &= left - 1)
        body(static_cast<std::uint32_t>(64 * w) +                  // [layout]
             static_cast<std::uint32_t>(std::countr_zero(left)));  // [layout]
    }
  }
  void clear() {
    for (std::size_t w = begin_; w < end_; ++w) words_[w] = 0;
    begin_ = words_.size();
    end_ = 0;
  }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t begin_ = 0, end_ = 0;  // range of words that may be nonzero
};

// Summary of the search of one group.
struct GroupResult {
  double greedy = 0, best = 0;
  std::vector<double> history_best,
      history_mean;  // per generation until it stopped; later ones equal the last
};

// Searches one group after another. The shared mask `selected` holds the current chromosome: one bit for each
// triangle of the group.
class GroupSearch {
 public:
  // All arguments must outlive it. `log_points`: log(points / 1000), at least 0.
  GroupSearch(const Candidates& candidates, const CandidateGroups& groups, const FanCorners& corners,
              const SearchOptions& options, Selection& selected, double log_points)
      : candidates_(candidates),
        groups_(groups),
        corners_(corners),
        options_(options),
        selected_(selected),
        log_points_(log_points) {}

  GroupResult search(const CandidateGroup& group, const Random& random);

  // Sets the current group. All its triangles must be selected.
  void start(const CandidateGroup& group);
  double fitness();
  // Flips the bits and returns the gain of fitness.
  double flip(std::span<const std::uint32_t> which);

 private:
  using Chromosome = std::vector<std::uint8_t>;

  struct Bit {
    std::uint32_t candidate;  // its position in Candidates::triangles
    Index triangle;
    double gain;                     // log odds of leaving it out, and more for each neighbour
    std::array<double, 3> contrast;  // that is selected; copied here because both are read together
    std::uint32_t near_count = 0;
    std::array<std::uint32_t, 3> beside{};    // bits of `now_` across its edges
    std::array<std::uint32_t, 4> near{};      // its own bit and those of its neighbours, ascending
    std::array<std::uint32_t, 3> corners{};   // its vertices, in the order of the triangle,
    std::array<std::uint32_t, 3> vertices{};  // and ascending,
    std::array<std::uint8_t, 3> places{};     // and its position among the bits of each
    std::uint8_t found = 0;                   // number of vertices set so far
  };
  struct Vertex {
    std::uint32_t slot;         // in Candidates::vertices
    std::uint32_t first, last;  // range of its bits in `at_vertex_`
    std::uint32_t costs;        // index into `costs_`, or `not_candidate` if it has too many bits
    std::uint32_t mask = 0;     // which of its bits are selected
  };
  struct Member {
    Chromosome genes;
    double fitness = 0;
  };
  // Triangles that are left out and connected over edges.
  struct Hole {
    std::vector<std::uint32_t> bits;
    bool outside = false;     // contains a free edge of the set
    double spread = 0;        // mean over the triangles
    double largest = -1e300;  // log_ratio
  };

  void find_vertices();
  void turn(std::uint32_t bit);
  void unsettle(std::uint32_t bit);
  void set(std::uint32_t bit, bool value);
  double cost(std::uint32_t vertex);
  double worth(std::uint32_t bit) const;
  double flip_one(std::uint32_t bit);
  double try_flip(std::span<const std::uint32_t> which);
  template <class Take>
  std::span<const std::uint32_t> region(std::uint32_t from, std::size_t most, const Take& take);

  std::uint32_t count() const { return static_cast<std::uint32_t>(bits_.size()); }
  void load(const Chromosome& genes);
  void load_by_size(double threshold);
  void store(Chromosome& genes) const { genes.assign(now_.begin(), now_.end() - 2); }
  std::span<const std::uint32_t> bits_at(const Vertex& vertex) const {
    return std::span(at_vertex_).subspan(vertex.first, vertex.last - vertex.first);
  }
  bool is_now(const Chromosome& genes) const { return std::equal(genes.begin(), genes.end(), now_.begin()); }
  void climb();
  void first_population(std::size_t size);
  void breed();

  double close_doubtful_holes();
  Hole hole_at(std::uint32_t start, std::vector<std::uint8_t>& seen) const;
  double least_gain(const Hole& hole) const;
  bool is_chance(double log_ratio) const;
  bool is_far_beyond_spread(const Hole& hole) const;

  const Candidates& candidates_;
  const CandidateGroups& groups_;
  const FanCorners& corners_;
  const SearchOptions& options_;
  Selection& selected_;
  double log_points_;
  Random random_{0};
  std::vector<Bit> bits_;
  std::vector<Vertex> vertices_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;  // slot and bit, ascending
  std::vector<std::uint32_t> at_vertex_;                        // the bits of `pairs_`
  std::vector<double> costs_;  // of each vertex and each mask of its bits; NaN: not computed yet
  Chromosome now_;  // the bits; then one for no triangle, and one for triangles that are no candidates
  std::vector<Member> members_;
  Chromosome start_;                   // start of the last climb
  std::vector<std::uint8_t> settled_;  // bits whose flip is known not to raise the fitness now
  Marks touched_, near_;               // vertices and bits
  std::vector<std::uint32_t> region_, stamp_;
  std::uint32_t epoch_ = 0;
};

}  // namespace rimline
