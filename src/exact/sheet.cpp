// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "parallel.h"
#include "rimline/unfilled.h"

namespace rimline::exact {
namespace {

constexpr std::size_t block_size = 8192;  // triangles that one task walks

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

// What blocks find side by side: no triangle is turned yet.
class Blocks {
 public:
  Blocks(const Complex& complex, const Kept& kept, const Run& run)
      : complex_(complex),
        kept_(kept),
        piece_of_(complex.size()),
        turned_(complex.size()),
        blocks_((static_cast<std::size_t>(complex.size()) + block_size - 1) / block_size) {
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
  // What is known of a triangle on the walk.
  using State = std::uint16_t;  // not of bytes, which might be any other thing for all the compiler knows
  using States = std::array<State, block_size>;
  static constexpr State is_turned = 1, is_reached = 2, is_out = 4;

  // A triangle, and the edge over which it was reached, named by the corner that it leaves.
  struct Member {
    Index triangle;
    int entry;
  };

  // The edge of a triangle that another lies across.
  int edge_to(Index t, Index other) const {
    const std::array<Index, 3>& beside = complex_.beside(t);
    return (beside[1] == other) + 2 * (beside[2] == other);
  }

  // Whether both run through the edge that leaves corner k of the first in opposite ways.
  bool agree(Index t, int k, Index other) const {
    return complex_.triangle(other)[edge_to(other, t)] != complex_.triangle(t)[k];
  }

  void walk(std::size_t b) {
    const Index begin = static_cast<Index>(b * block_size);
    const Index end = static_cast<Index>(std::min<std::size_t>(complex_.size(), (b + 1) * block_size));
    States state;
    for (Index t = begin; t < end; ++t) {
      state[t - begin] = kept_[t] ? 0 : is_out;
      piece_of_[t] = none;
    }
    std::vector<Member> members(end - begin + 1);  // one more is written than there are
    std::vector<Piece>& pieces = blocks_[b].pieces;
    for (Index t = begin; t < end; ++t) {
      if (state[t - begin] != 0) continue;
      pieces.push_back({t});
      walk_piece(blocks_[b], {begin, end}, state, members);
    }
    for (Index t = begin; t < end; ++t) turned_[t] = (state[t - begin] & is_turned) != 0;
    const Points p = complex_.points();
    for (Index t = begin; t < end; ++t) {
      if (piece_of_[t] == none) continue;
      Piece& piece = pieces[piece_of_[t]];
      const Triangle& x = complex_.triangle(t);
      const Point normal = cross(p[x[1]] - p[x[0]], p[x[2]] - p[x[0]]);
      piece.normal = piece.normal + (1.0 - 2.0 * turned_[t]) * normal;
      piece.area += norm(normal);
    }
  }

  // Hardly branches, for each triangle is reached from two or three others in no order that could be guessed.
  void walk_piece(Block& block, std::pair<Index, Index> range, States& state, std::vector<Member>& members) {
    const auto [begin, end] = range;
    const auto number = static_cast<Index>(block.pieces.size()) - 1;
    Piece& piece = block.pieces.back();
    members[0] = {piece.first, 0};
    state[piece.first - begin] = is_reached;
    std::size_t count = 1;
    State differ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [t, entry] = members[i];
      const State own = state[t - begin] & is_turned;
      piece_of_[t] = number;
      for (int step = i == 0 ? 0 : 1; step < 3; ++step) {
        const int k = entry + step < 3 ? entry + step : entry + step - 3;
        const Index other = complex_.across(t, k);
        if (other < begin || other >= end) {  // none is less
          if (t < other && kept_[other]) block.seams.push_back({t, other, agree(t, k, other)});
          continue;
        }
        const State before = state[other - begin];
        if (before == is_out) continue;
        const int back = edge_to(other, t);
        const bool agrees = complex_.triangle(other)[back] != complex_.triangle(t)[k];
        const State as_here = is_reached | (own ^ !agrees);
        const bool is_new = before == 0;
        const State now = is_new ? as_here : before;
        state[other - begin] = now;
        differ |= now ^ as_here;
        members[count] = {other, back};
        count += is_new;
      }
    }
    piece.orientable = differ == 0;
  }

  const Complex& complex_;
  const Kept& kept_;
  UnfilledVector<Index> piece_of_;  // of each triangle, in its block; none where it is not kept
  UnfilledVector<std::uint8_t> turned_;
  std::vector<Block> blocks_;
  std::vector<Index> start_;  // of the pieces of each block
};

// Which pieces hang together, and which of them lie the other way.
class Joins {
 public:
  explicit Joins(Index count) : parent_(count), turned_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
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

// Whether a triangle with corners a and b runs from a to b.
bool has_directed_edge(const Triangle& t, Index a, Index b) {
  const int next = (t[0] == a) + 2 * (t[1] == a);
  return t[next] == b;
}

// All triangles of one component, from its first; each is turned to agree with the one it was reached from.
// Only where they can not all agree does it matter which way the walk took.
std::vector<Index> walk_sheet(Complex& complex, const Kept& kept, Index first, Index sheet,
                              std::vector<Index>& of_triangle) {
  std::vector<Index> members{first};
  of_triangle[first] = sheet;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Triangle t = complex.triangle(members[i]);
    for (int k = 0; k < 3; ++k) {
      const Index other = complex.across(members[i], k);
      if (other == none || !kept[other] || of_triangle[other] != none) continue;
      if (has_directed_edge(complex.triangle(other), t[k], t[(k + 1) % 3])) complex.flip(other);
      of_triangle[other] = sheet;
      members.push_back(other);
    }
  }
  return members;
}

bool faces_up(Point normal, double area) {
  for (const double c : {normal.z, normal.y, normal.x}) {
    if (std::abs(c) > 1e-3 * area) return c > 0;
  }
  return true;
}

void orient_one_sided(Complex& complex, const Kept& kept, Index first, Index sheet,
                      std::vector<Index>& of_triangle) {
  const std::vector<Index> members = walk_sheet(complex, kept, first, sheet, of_triangle);
  const Points p = complex.points();
  Point sum;
  double area = 0;
  for (const Index t : members) {
    const Triangle& x = complex.triangle(t);
    const Point normal = cross(p[x[1]] - p[x[0]], p[x[2]] - p[x[0]]);
    sum = sum + normal;
    area += norm(normal);
  }
  if (faces_up(sum, area)) return;
  for (const Index t : members) complex.flip(t);
}

}  // namespace

Sheets orient_sheets(Complex& complex, const Kept& kept, const Run& run) {
  const Blocks blocks(complex, kept, run);
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
  std::vector<Index> sheet_of(blocks.count());
  std::vector<std::uint8_t> turn(blocks.count());
  std::vector<Sum> sums;
  Sheets sheets;
  Index piece = 0;
  for (const Block& block : blocks.all()) {
    for (const Piece& x : block.pieces) {
      const auto [root, turned] = joins.find(piece);
      if (root == piece) {
        sheet_of[piece] = sheets.count();
        sheets.orientable.push_back(1);
        sums.push_back({.first = x.first});
      }
      const Index sheet = sheet_of[piece] = sheet_of[root];
      turn[piece] = turned;
      sums[sheet].normal = sums[sheet].normal + (turned ? -1.0 : 1.0) * x.normal;
      sums[sheet].area += x.area;
      if (!x.orientable || one_sided[piece]) sheets.orientable[sheet] = 0;
      ++piece;
    }
  }
  for (Index i = 0; i < blocks.count(); ++i) {
    const Sum& sum = sums[sheet_of[i]];
    turn[i] ^= !faces_up(sum.normal, sum.area);
  }
  sheets.of_triangle.assign(complex.size(), none);
  parallel_for_each(complex.size(), Stage::Loops, run, [&](Index t) {
    const Index own = blocks.piece(t);
    if (own == none || !sheets.orientable[sheet_of[own]]) return;
    sheets.of_triangle[t] = sheet_of[own];
    complex.flip_if(t, (turn[own] != 0) != blocks.turned(t));
  });
  for (Index s = 0; s < sheets.count(); ++s) {
    if (!sheets.orientable[s]) orient_one_sided(complex, kept, sums[s].first, s, sheets.of_triangle);
  }
  return sheets;
}

}  // namespace rimline::exact
