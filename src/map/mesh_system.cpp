// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/mesh_system.h"

#include <algorithm>

#include "base/parallel.h"
#include "map/weights.h"

namespace rimline {
namespace {

struct Entry {
  Index node;
  double weight;
};

// The neighbours of one node, gathered in any order, then ascending and each once.
class Row {
 public:
  void clear() { entries_.clear(); }
  void add(Index node, double weight) { entries_.push_back({node, weight}); }
  const std::vector<Entry>& entries() const { return entries_; }

  // Equal nodes keep their order, so that their sum is always the same.
  void merge() {
    constexpr std::size_t short_row = 64;  // enough except for the centres of large holes
    if (entries_.size() > short_row) {
      std::stable_sort(entries_.begin(), entries_.end(),
                       [](const Entry& a, const Entry& b) { return a.node < b.node; });
    } else {
      sort_by_insertion();
    }
    std::size_t used = 0;
    for (const Entry& e : entries_) {
      if (used > 0 && entries_[used - 1].node == e.node)
        entries_[used - 1].weight += e.weight;
      else
        entries_[used++] = e;
    }
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(used), entries_.end());
  }

 private:
  void sort_by_insertion() {
    for (std::size_t i = 1; i < entries_.size(); ++i) {
      const Entry moved = entries_[i];
      std::size_t at = i;
      for (; at > 0 && entries_[at - 1].node > moved.node; --at) entries_[at] = entries_[at - 1];
      entries_[at] = moved;
    }
  }

  std::vector<Entry> entries_;
};

class Assembler {
 public:
  Assembler(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
            std::span<const double> evenness, const std::vector<char>& fixed, const std::vector<UV>& uv)
      : points_(points),
        mesh_(mesh),
        evenness_(evenness),
        fixed_(fixed),
        uv_(uv),
        star_(points.size(), none) {
    std::vector<WeightedEdge> wheels;
    add_wheels(loops, static_cast<Index>(points.size()), wheels);
    if (!wheels.empty()) wheels_ = make_graph(static_cast<Index>(fixed.size()), wheels);
    for (Index t = 0; t < mesh.size(); ++t) {
      for (const Index v : mesh.triangles[t]) star_[v] = t;
    }
  }

  MapSystem assemble(const Run& run) {
    MapSystem system;
    const Index nodes = static_cast<Index>(fixed_.size());
    system.unknown.assign(nodes, none);
    std::vector<Index> node_of;
    for (Index i = 0; i < nodes; ++i) {
      if (fixed_[i]) continue;
      system.unknown[i] = static_cast<Index>(node_of.size());
      node_of.push_back(i);
    }
    SymmetricMatrix& a = system.matrix;
    a.diagonal.resize(node_of.size());
    system.right.resize(node_of.size());
    // Two passes around each node: one to count, one to fill in.
    std::vector<Index> counts(node_of.size());
    for_each_row(node_of, false, run, [&](Index row, const std::vector<Entry>& entries) {
      counts[row] = static_cast<Index>(
          std::count_if(entries.begin(), entries.end(), [&](const Entry& e) { return !fixed_[e.node]; }));
    });
    a.offsets.reserve(node_of.size() + 1);
    for (const Index count : counts) a.offsets.push_back(a.offsets.back() + count);
    a.columns.resize(a.offsets.back());
    a.values.resize(a.offsets.back());
    for_each_row(node_of, true, run, [&](Index row, const std::vector<Entry>& entries) {
      Index at = a.offsets[row];
      double sum = 0;
      UV held;
      for (const Entry& e : entries) {
        sum += e.weight;
        if (fixed_[e.node]) {
          held = held + e.weight * uv_[e.node];
        } else {
          a.columns[at] = system.unknown[e.node];
          a.values[at++] = -e.weight;
        }
      }
      a.diagonal[row] = sum;
      system.right[row] = held;
    });
    return system;
  }

 private:
  // Calls body(row, entries) for all rows; without `weighted` all weights are 0.
  template <class Body>
  void for_each_row(const std::vector<Index>& node_of, bool weighted, const Run& run,
                    const Body& body) const {
    parallel_slices(node_of.size(), Stage::Refine, run, [&](std::size_t begin, std::size_t end) {
      Row row;
      for (std::size_t i = begin; i < end; ++i) {
        gather(node_of[i], weighted, row);
        body(static_cast<Index>(i), row.entries());
      }
    });
  }

  void gather(Index node, bool weighted, Row& row) const {
    row.clear();
    if (node < static_cast<Index>(points_.size())) gather_mesh(node, weighted, row);
    if (wheels_.size() > 0) {
      for (Index e = wheels_.offsets[node]; e < wheels_.offsets[node + 1]; ++e)
        row.add(wheels_.neighbours[e], wheels_.weights[e]);
    }
    row.merge();
  }

  // Around the vertex, both ways where the boundary is met.
  void gather_mesh(Index vertex, bool weighted, Row& row) const {
    const auto weight = [&](Index t, int c) {
      return weighted ? cotangent_weight(points_, mesh_, t, c, evenness_) : 0;
    };
    const Index first = star_[vertex];
    if (first == none) return;
    for (Index at = first;;) {
      const int c = mesh_.corner_of(at, vertex);
      row.add(mesh_.triangles[at][next(c)], weight(at, previous(c)));
      const Index beyond = mesh_.adjacent[at][next(c)];
      if (beyond == first) return;
      if (beyond == none) {
        row.add(mesh_.triangles[at][previous(c)], weight(at, next(c)));
        break;
      }
      at = beyond;
    }
    for (Index at = first;;) {
      at = mesh_.adjacent[at][previous(mesh_.corner_of(at, vertex))];
      if (at == none) return;
      row.add(mesh_.triangles[at][next(mesh_.corner_of(at, vertex))],
              weight(at, previous(mesh_.corner_of(at, vertex))));
    }
  }

  Points points_;
  const Triangulation& mesh_;
  std::span<const double> evenness_;
  const std::vector<char>& fixed_;
  const std::vector<UV>& uv_;
  std::vector<Index> star_;  // a triangle of each point
  Graph wheels_;             // empty where there is no hole
};

}  // namespace

MapSystem mesh_system(Points points, const Triangulation& mesh, const std::vector<Loop>& loops,
                      std::span<const double> evenness, const std::vector<char>& fixed,
                      const std::vector<UV>& uv, const Run& run) {
  return Assembler(points, mesh, loops, evenness, fixed, uv).assemble(run);
}

}  // namespace rimline
