// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/components.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "rimline/unfilled.h"

namespace rimline {
namespace {

constexpr std::size_t block_size = 8192;  // triangles that one task walks [speed]

// The part of a component that lies in one block of triangles, or a piece of it.
struct Piece {
  Index first;  // its first triangle
  bool orientable = true;
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

// Disjoint sets of pieces, with the orientation of each piece relative to its set.
class Joins {
 public:
  explicit Joins(Index count = 0) : parent_(count), turned_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  Index count() const { return static_cast<Index>(parent_.size()); }
  // Adds a piece in a set of its own.
  Index add() {
    parent_.push_back(count());
    turned_.push_back(0);
    return count() - 1;
  }

  // The representative of a piece's set, and whether the piece is turned against it.
  std::pair<Index, bool> find(Index piece) {
    Index root = piece;
    bool turned = false;
    for (; parent_[root] != root; root = parent_[root]) turned ^= turned_[root] != 0;
    for (bool left = turned; parent_[piece] != piece;) {  // path compression
      const bool own = turned_[piece] != 0;
      turned_[piece] = left;
      left ^= own;
      piece = std::exchange(parent_[piece], root);
    }
    return {root, turned};
  }

  // False where the two are in one set already and contradict in orientation.
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

// The pieces of all blocks, found in parallel; no triangle is turned yet.
class Blocks {
 public:
  Blocks(const Triangulation& mesh, std::span<const std::uint8_t> selected, const Run& run)
      : mesh_(mesh),
        selected_(selected),
        piece_of_(mesh.triangles.size()),
        turned_(mesh.triangles.size()),
        blocks_((mesh.triangles.size() + block_size - 1) / block_size) {
    if (blocks_.size() == 1) {  // small meshes need no threads
      walk(0);
    } else {
      parallel_tasks(blocks_.size(), Stage::Loops, run, [&](std::size_t b) { walk(b); });
      run.check_cancel();
    }
    // Numbers the pieces of all blocks consecutively.
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
  // State of a triangle: twice the number of its part, plus one where it is turned against the first there.
  using State = std::uint32_t;
  static constexpr State out = ~State{0};  // it is not selected

  // The triangles of a block and their parts, some of which are connected.
  struct Parts {
    std::array<State, block_size + 1> state;  // the last one is out
    Joins joins;
    std::vector<Index> first;      // triangle of each part
    std::vector<Index> one_sided;  // parts with triangles that can not all agree
  };

  static Index part_of(State state) { return static_cast<Index>(state / 2); }
  static bool is_turned(State state) { return state % 2 != 0; }
  bool is_selected(Index t) const { return selected_.empty() || selected_[t]; }

  void walk(std::size_t b) {
    const Index begin = static_cast<Index>(b * block_size);
    const Index end = static_cast<Index>(std::min(mesh_.triangles.size(), (b + 1) * block_size));
    Parts parts;
    parts.state.back() = out;
    for (Index t = begin; t < end; ++t) {
      parts.state[t - begin] = is_selected(t) ? place(t, {begin, end}, parts, blocks_[b].seams) : out;
    }
    number(begin, end, parts, blocks_[b].pieces);
  }

  // Adds a triangle to the parts of its neighbours that came before. Nearly free of branches, which would be
  // mispredicted.
  State place(Index t, std::pair<Index, Index> range, Parts& parts, std::vector<Seam>& seams) const {
    const Index begin = range.first, end = range.second;
    const Triangle x = mesh_.triangles[t];
    const std::array<Index, 3>& beside = mesh_.adjacent[t];  // of the edges opposite to its corners
    if ((beside[0] >= end) | (beside[1] >= end) | (beside[2] >= end)) find_seams(t, end, seams);
    const Triangle* triangles = mesh_.triangles.data();
    // The state of this triangle by its neighbour across an edge.
    const auto said_by = [&](Index other, Index from, Index to) {
      const bool is_before = (other >= begin) & (other < t);
      const State there = parts.state[is_before ? other - begin : block_size];
      const bool agrees = runs(triangles[is_before ? other : t], to, from);
      return there == out ? out : there ^ static_cast<State>(!agrees);
    };
    const std::array by{said_by(beside[2], x[0], x[1]), said_by(beside[0], x[1], x[2]),
                        said_by(beside[1], x[2], x[0])};
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
    const Triangle& x = mesh_.triangles[t];
    for (int c = 0; c < 3; ++c) {
      const Index other = mesh_.adjacent[t][c];
      if (other >= end && is_selected(other))
        seams.push_back({t, other, runs(mesh_.triangles[other], x[previous(c)], x[next(c)])});
    }
  }

  // Pieces are connected parts, numbered by their first triangles.
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
    }
  }

  const Triangulation& mesh_;
  std::span<const std::uint8_t> selected_;  // empty: all
  UnfilledVector<Index> piece_of_;          // of each triangle, in its block; none where it is not selected
  UnfilledVector<std::uint8_t> turned_;
  std::vector<Block> blocks_;
  std::vector<Index> start_;  // of the pieces of each block
};

// Walks a component from its first triangle; each is turned to agree with the one it was reached from. Only
// where they can not all agree does it matter which way the walk took.
void walk_one_sided(const Triangulation& mesh, std::span<const std::uint8_t> selected, Index first,
                    Index number, Components& components) {
  std::vector<Index> members{first};
  components.of_triangle[first] = number;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const bool is_turned = components.turned[members[i]] != 0;
    const Triangle& x = mesh.triangles[members[i]];
    const Triangle t = is_turned ? Triangle{x[0], x[2], x[1]} : x;
    for (int k = 0; k < 3; ++k) {
      const Index other = mesh.adjacent[members[i]][previous(is_turned ? 2 - k : k)];
      if (other == none || components.of_triangle[other] != none) continue;
      if (!selected.empty() && !selected[other]) continue;
      components.turned[other] = runs(mesh.triangles[other], t[k], t[next(k)]);
      components.of_triangle[other] = number;
      members.push_back(other);
    }
  }
}

// Pieces of different blocks that are connected.
struct Joined {
  Joins joins;
  std::vector<std::uint8_t> one_sided;  // pieces with a seam that can not agree
};

Joined join_blocks(const Blocks& blocks) {
  Joined joined{Joins(blocks.count()), std::vector<std::uint8_t>(blocks.count(), 0)};
  for (const Block& block : blocks.all()) {
    for (const Seam& seam : block.seams) {
      const bool turned = seam.agrees == (blocks.turned(seam.from) != blocks.turned(seam.to));
      const Index piece = blocks.piece(seam.from);
      if (!joined.joins.join(piece, blocks.piece(seam.to), turned)) joined.one_sided[piece] = 1;
    }
  }
  return joined;
}

}  // namespace

Components find_components(const Triangulation& mesh, std::span<const std::uint8_t> selected,
                           const Run& run) {
  const Blocks blocks(mesh, selected, run);
  Joined joined = join_blocks(blocks);
  // Pieces ascend by their first triangles, and so do the roots: a root's first is that of its component.
  std::vector<Index> component_of(blocks.count()), first_of;
  std::vector<std::uint8_t> turn(blocks.count());
  Components components;
  Index piece = 0;
  for (const Block& block : blocks.all()) {
    for (const Piece& x : block.pieces) {
      const auto [root, turned] = joined.joins.find(piece);
      if (root == piece) {
        component_of[piece] = components.count();
        components.orientable.push_back(1);
        first_of.push_back(x.first);
      }
      const Index component = component_of[piece] = component_of[root];
      turn[piece] = turned;
      if (!x.orientable || joined.one_sided[piece]) components.orientable[component] = 0;
      ++piece;
    }
  }
  components.of_triangle.assign(mesh.triangles.size(), none);
  components.turned.assign(mesh.triangles.size(), 0);
  const auto put = [&](Index t) {
    const Index own = blocks.piece(t);
    if (own == none || !components.orientable[component_of[own]]) return;
    components.of_triangle[t] = component_of[own];
    components.turned[t] = (turn[own] != 0) != blocks.turned(t);
  };
  if (blocks.all().size() == 1) {
    for (Index t = 0; t < mesh.size(); ++t) put(t);
  } else {
    parallel_for_each(mesh.triangles.size(), Stage::Loops, run, put);
  }
  for (Index c = 0; c < components.count(); ++c) {
    if (!components.orientable[c]) walk_one_sided(mesh, selected, first_of[c], c, components);
  }
  return components;
}

}  // namespace rimline
