// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "base/vec.h"
#include "rimline/unfilled.h"

namespace rimline {
namespace {

constexpr std::size_t block_size = 8192;  // triangles that one task walks [speed]

// The part of a component that lies in one block of triangles, or a piece of it.
struct Piece {
  Index first;  // its first triangle
  bool orientable = true;
  Point normal = {};  // sums over its triangles, turned as the first lies
  double area = 0;
};

// An edge between triangles of two blocks.
struct Seam {
  Index from, to;
  bool agrees;  // whether both, as they lie, run through the edge in opposite ways
};

struct Block {
  std::vector<Piece> pieces;  // by first triangle
  std::vector<Seam> seams;
};

// Which of some pieces hang together, and which of them lie the other way.
class Joins {
 public:
  explicit Joins(Index count = 0) : parent_(count), turned_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  Index count() const { return static_cast<Index>(parent_.size()); }
  // One more, which hangs together with no other.
  Index add() {
    parent_.push_back(count());
    turned_.push_back(0);
    return count() - 1;
  }

  // The piece that stands for all that hang together, and whether this one is turned against it.
  std::pair<Index, bool> find(Index piece) {
    Index root = piece;
    bool turned = false;
    for (; parent_[root] != root; root = parent_[root]) turned ^= turned_[root] != 0;
    for (bool left = turned; parent_[piece] != piece;) {  // shortens the way for the next time
      const bool own = turned_[piece] != 0;
      turned_[piece] = left;
      left ^= own;
      piece = std::exchange(parent_[piece], root);
    }
    return {root, turned};
  }

  // False where the two hang together already and lie differently.
  bool join(Index a, Index b, bool turned) {
    const auto [root_a, turned_a] = find(a);
    const auto [root_b, turned_b] = find(b);
    if (root_a == root_b) return (turned_a != turned_b) == turned;
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    turned_[std::max(root_a, root_b)] = turned_a ^ turned_b ^ turned;
    return true;
  }

 private:
  std::vector<Index> parent_;
  std::vector<std::uint8_t> turned_;  // against the parent
};

// Whether a triangle runs along its edge from a to b, not from b to a.
bool runs(const Triangle& t, Index a, Index b) {
  return ((t[0] == a) & (t[1] == b)) | ((t[1] == a) & (t[2] == b)) | ((t[2] == a) & (t[0] == b));
}

// What blocks find side by side: no triangle is turned yet.
class Blocks {
 public:
  Blocks(const TriangleSet& set, const Selection& selected, const Run& run)
      : set_(set),
        selected_(selected),
        piece_of_(set.size()),
        turned_(set.size()),
        blocks_((static_cast<std::size_t>(set.size()) + block_size - 1) / block_size) {
    parallel_tasks(blocks_.size(), Stage::Loops, run, [&](std::size_t b) { walk(b); });
    run.check_cancel();
    // Numbered through.
    start_.push_back(0);
    for (const Block& block : blocks_)
      start_.push_back(start_.back() + static_cast<Index>(block.pieces.size()));
  }

  Index count() const { return start_.back(); }
  const std::vector<Block>& all() const { return blocks_; }
  Index piece(Index t) const {
    return piece_of_[t] == none ? none : start_[static_cast<std::size_t>(t) / block_size] + piece_of_[t];
  }
  // Whether the triangle would have to be turned to agree with the first of its piece.
  bool turned(Index t) const { return turned_[t] != 0; }

 private:
  // Of a triangle: twice the number of its part, one more where it is turned against the first there.
  using State = std::uint32_t;
  static constexpr State out = ~State{0};  // it is not selected

  // What is known of the triangles of a block, and of their parts, some of which hang together.
  struct Parts {
    std::array<State, block_size + 1> state;  // the last one is out
    Joins joins;
    std::vector<Index> first;      // triangle of each part
    std::vector<Index> one_sided;  // parts with triangles that can not all agree
  };

  static Index part_of(State state) { return static_cast<Index>(state / 2); }
  static bool is_turned(State state) { return state % 2 != 0; }

  void walk(std::size_t b) {
    const Index begin = static_cast<Index>(b * block_size);
    const Index end = static_cast<Index>(std::min<std::size_t>(set_.size(), (b + 1) * block_size));
    Parts parts;
    parts.state.back() = out;
    for (Index t = begin; t < end; ++t) {
      parts.state[t - begin] = selected_[t] ? place(t, {begin, end}, parts, blocks_[b].seams) : out;
    }
    number(begin, end, parts, blocks_[b].pieces);
  }

  // Joins a triangle to the parts of those beside it that came before. Hardly branches, for there is no order
  // in which of them these are that could be guessed.
  State place(Index t, std::pair<Index, Index> range, Parts& parts, std::vector<Seam>& seams) const {
    const Index begin = range.first, end = range.second;
    const Triangle x = set_.triangle(t);
    const std::array<Index, 3> beside = set_.beside(t);
    if ((beside[0] >= end) | (beside[1] >= end) | (beside[2] >= end)) find_seams(t, end, seams);
    const Triangle* triangles = set_.triangles().data();
    // What the one beside it there says of this one.
    const auto said_by = [&](Index other, Index from, Index to) {
      const bool is_before = (other >= begin) & (other < t);
      const State there = parts.state[is_before ? other - begin : block_size];
      const bool agrees = runs(triangles[is_before ? other : t], to, from);
      return there == out ? out : there ^ static_cast<State>(!agrees);
    };
    const std::array by{said_by(beside[0], x[0], x[1]), said_by(beside[1], x[1], x[2]),
                        said_by(beside[2], x[2], x[0])};
    State own = std::min({by[0], by[1], by[2]});
    if (own == out) {
      parts.first.push_back(t);
      return 2 * static_cast<State>(parts.joins.add());
    }
    const auto differs = [&](State other) { return (other != out) & (other != own); };
    if (!(differs(by[0]) | differs(by[1]) | differs(by[2]))) return own;
    for (const State other : by) {
      if (differs(other) &&
          !parts.joins.join(part_of(own), part_of(other), is_turned(own) != is_turned(other)))
        parts.one_sided.push_back(part_of(own));
    }
    const auto [root, turned] = parts.joins.find(part_of(own));
    return 2 * static_cast<State>(root) + static_cast<State>(is_turned(own) != turned);
  }

  void find_seams(Index t, Index end, std::vector<Seam>& seams) const {
    const Triangle& x = set_.triangle(t);
    for (int k = 0; k < 3; ++k) {
      const Index other = set_.across(t, k);
      if (other >= end && selected_[other])
        seams.push_back({t, other, runs(set_.triangle(other), x[next_in(k, 3)], x[k])});
    }
  }

  // Pieces are parts that hang together, numbered as their first triangles are.
  void number(Index begin, Index end, Parts& parts, std::vector<Piece>& pieces) {
    std::vector<State> state_of(parts.first.size());  // of the first triangle of each part, in its piece
    for (Index part = 0; part < parts.joins.count(); ++part) {
      const auto [root, turned] = parts.joins.find(part);
      if (root == part) {
        state_of[part] = static_cast<State>(2 * pieces.size());
        pieces.push_back({parts.first[part]});
      } else {
        state_of[part] = state_of[root] ^ static_cast<State>(turned);
      }
    }
    for (const Index part : parts.one_sided) pieces[part_of(state_of[part])].orientable = false;
    const Points p = set_.points();
    for (Index t = begin; t < end; ++t) {
      const State in_part = parts.state[t - begin];
      if (in_part == out) {
        piece_of_[t] = none;
        turned_[t] = 0;
        continue;
      }
      const State state = state_of[part_of(in_part)] ^ (in_part & 1);
      piece_of_[t] = part_of(state);
      turned_[t] = is_turned(state);
      Piece& piece = pieces[part_of(state)];
      const Triangle& x = set_.triangle(t);
      const Point normal = triangle_normal(p, x);
      piece.normal = piece.normal + (1.0 - 2.0 * turned_[t]) * normal;
      piece.area += norm(normal);
    }
  }

  const TriangleSet& set_;
  const Selection& selected_;
  UnfilledVector<Index> piece_of_;  // of each triangle, in its block; none where it is not selected
  UnfilledVector<std::uint8_t> turned_;
  std::vector<Block> blocks_;
  std::vector<Index> start_;  // of the pieces of each block
};

// All triangles of one component, from its first; each is turned to agree with the one it was reached from.
// Only where they can not all agree does it matter which way the walk took.
std::vector<Index> walk_component(const TriangleSet& set, const Selection& selected, Index first,
                                  Index number, Components& components) {
  std::vector<Index> members{first};
  components.of_triangle[first] = number;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const bool is_turned = components.turned[members[i]] != 0;
    const Triangle& x = set.triangle(members[i]);
    const Triangle t = is_turned ? Triangle{x[0], x[2], x[1]} : x;
    for (int k = 0; k < 3; ++k) {
      const Index other = set.across(members[i], is_turned ? 2 - k : k);
      if (other == none || !selected[other] || components.of_triangle[other] != none) continue;
      components.turned[other] = runs(set.triangle(other), t[k], t[next_in(k, 3)]);
      components.of_triangle[other] = number;
      members.push_back(other);
    }
  }
  return members;
}

bool faces_up(Point normal, double area) {
  for (const double c : {normal.z, normal.y, normal.x}) {
    if (std::abs(c) > 1e-3 * area) return c > 0;  // [guard] nearly 0 is no direction
  }
  return true;
}

void orient_one_sided(const TriangleSet& set, const Selection& selected, Index first, Index number,
                      Components& components) {
  const std::vector<Index> members = walk_component(set, selected, first, number, components);
  const Points p = set.points();
  Point sum;
  double area = 0;
  for (const Index t : members) {
    const Triangle& x = set.triangle(t);
    const Point normal = triangle_normal(p, x);
    sum = sum + (components.turned[t] ? -1.0 : 1.0) * normal;
    area += norm(normal);
  }
  if (faces_up(sum, area)) return;
  for (const Index t : members) components.turned[t] ^= 1;
}

}  // namespace

Components find_components(const TriangleSet& set, const Selection& selected, const Run& run) {
  const Blocks blocks(set, selected, run);
  Joins joins(blocks.count());
  std::vector<std::uint8_t> one_sided(blocks.count(), 0);
  for (const Block& block : blocks.all()) {
    for (const Seam& seam : block.seams) {
      const bool turned = seam.agrees == (blocks.turned(seam.from) != blocks.turned(seam.to));
      if (!joins.join(blocks.piece(seam.from), blocks.piece(seam.to), turned)) {
        one_sided[blocks.piece(seam.from)] = 1;
      }
    }
  }
  // Pieces ascend by their first triangles, and so do the roots: a root's first is that of its component.
  struct Sum {
    Point normal = {};
    double area = 0;
    Index first = none;
  };
  std::vector<Index> component_of(blocks.count());
  std::vector<std::uint8_t> turn(blocks.count());
  std::vector<Sum> sums;
  Components components;
  Index piece = 0;
  for (const Block& block : blocks.all()) {
    for (const Piece& x : block.pieces) {
      const auto [root, turned] = joins.find(piece);
      if (root == piece) {
        component_of[piece] = components.count();
        components.orientable.push_back(1);
        sums.push_back({.first = x.first});
      }
      const Index component = component_of[piece] = component_of[root];
      turn[piece] = turned;
      sums[component].normal = sums[component].normal + (turned ? -1.0 : 1.0) * x.normal;
      sums[component].area += x.area;
      if (!x.orientable || one_sided[piece]) components.orientable[component] = 0;
      ++piece;
    }
  }
  for (Index i = 0; i < blocks.count(); ++i) {
    const Sum& sum = sums[component_of[i]];
    turn[i] ^= !faces_up(sum.normal, sum.area);
  }
  components.of_triangle.assign(set.size(), none);
  components.turned.assign(set.size(), 0);
  parallel_for_each(set.size(), Stage::Loops, run, [&](Index t) {
    const Index own = blocks.piece(t);
    if (own == none || !components.orientable[component_of[own]]) return;
    components.of_triangle[t] = component_of[own];
    components.turned[t] = (turn[own] != 0) != blocks.turned(t);
  });
  for (Index s = 0; s < components.count(); ++s) {
    if (!components.orientable[s]) orient_one_sided(set, selected, sums[s].first, s, components);
  }
  return components;
}

TriangleSet turn_over(TriangleSet set, const std::vector<std::uint8_t>& marked, const Run& run) {
  parallel_for_each(set.size(), Stage::Loops, run, [&](Index t) { set.flip_if(t, marked[t] != 0); });
  return set;
}

}  // namespace rimline
