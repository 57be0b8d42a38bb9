// SPDX-License-Identifier: GPL-3.0-or-later
// The k nearest points of all points of a leaf at once.
#pragma once

#include <cstdint>
#include <vector>

#include "points/kd_tree.h"
#include "rimline/neighbours.h"

namespace rimline {

// All points of a leaf look at the same places: those in leaves within a radius that sufficed for the leaf
// before. Distances are compared in single precision first, with a margin for its error; what passes is
// compared exactly, so that the lists are those of brute force whatever the radius was. A point for which it
// was too small searches the tree alone.  [ours]
class LeafSearch {
 public:
  LeafSearch(const KdTree& tree, int k);

  // Writes the lists of the leaf's points into their slots of `result`.
  void search(std::size_t leaf, Neighbours& result);

 private:
  struct Found {
    double squared;  // distance
    Index place;     // in the tree
  };

  bool gather(std::size_t own);
  bool search_gathered(std::size_t place);
  bool search_within(double reach, std::size_t place);
  void sort_passed(std::size_t count, Point point);
  void sort_found();
  void take_found();
  void search_tree(std::size_t place);
  void visit(std::size_t at, std::size_t place);
  bool before(const Found& a, const Found& b) const;
  void write(std::size_t place, Neighbours& result) const;

  const KdTree& tree_;
  std::size_t k_;
  // Of the point that is searched for, sorted, k of them or more.
  std::vector<Index> nearest_;   // places
  std::vector<double> squared_;  // distances
  std::vector<Found> found_;     // both, on the way there

  double radius_ = 0;
  double reach_ = 1;                  // radii that sufficed for the point before, and a little more
  double margin_ = 0;                 // by which a distance in single precision, in radii, may be too large
  std::size_t first_ = 0, self_ = 0;  // place and position in the gathered of the leaf's first point
  std::vector<std::size_t> stack_;
  std::vector<std::size_t> runs_;   // of places that are gathered: begin and end of each
  std::vector<Index> places_;       // gathered for the leaf
  std::vector<float> x_, y_, z_;    // of the gathered, from the centre of the leaf, in radii
  std::vector<Index> passed_;       // the places of what may be within reach
  std::vector<std::int32_t> keys_;  // of those that passed: the bits of their squared distances
};

}  // namespace rimline
