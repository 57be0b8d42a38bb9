// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/groups.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cstddef>

#include "solve/blocks.h"

namespace rimline {
namespace {

void list_members(Groups& groups, Index count) {
  groups.offsets.assign(count + 1, 0);
  for (const Index g : groups.of) ++groups.offsets[g + 1];
  for (Index g = 0; g < count; ++g) groups.offsets[g + 1] += groups.offsets[g];
  groups.members.resize(groups.of.size());
  std::vector<Index> at(groups.offsets.begin(), groups.offsets.end() - 1);
  for (Index i = 0; i < static_cast<Index>(groups.of.size()); ++i) groups.members[at[groups.of[i]]++] = i;
}

// Each row with the row that it depends on most, of those not yet taken; rows whose strong partners are all
// taken join the pair of the strongest.
Groups pair_rows(const RowMatrix& a) {
  constexpr double strong = 0.25;  // of the row's largest entry (Notay 2012, section 3)
  Groups groups;
  groups.of.assign(a.size(), none);
  Index count = 0;
  for (Index i = 0; i < a.size(); ++i) {
    if (groups.of[i] != none) continue;
    double largest = 0, best = 0;
    Index partner = none;
    for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
      largest = std::max(largest, -a.values[e]);
      if (groups.of[a.columns[e]] == none && -a.values[e] > best) {
        best = -a.values[e];
        partner = a.columns[e];
      }
    }
    if (partner == none || best < strong * largest) continue;
    groups.of[i] = groups.of[partner] = count++;
  }
  const std::vector<Index> paired = groups.of;
  for (Index i = 0; i < a.size(); ++i) {
    double best = 0;
    for (Index e = a.offsets[i]; paired[i] == none && e < a.offsets[i + 1]; ++e) {
      if (paired[a.columns[e]] == none || -a.values[e] <= best) continue;
      best = -a.values[e];
      groups.of[i] = paired[a.columns[e]];
    }
    if (groups.of[i] == none) groups.of[i] = count++;
  }
  list_members(groups, count);
  return groups;
}

// The groups of groups, by the rows of the first.
Groups composed(const Groups& inner, const Groups& outer) {
  Groups result;
  result.of.resize(inner.of.size());
  for (std::size_t i = 0; i < inner.of.size(); ++i) result.of[i] = outer.of[inner.of[i]];
  list_members(result, outer.count());
  return result;
}

// The sums of a over groups of rows and columns.
RowMatrix summed(const RowMatrix& a, const Groups& groups) {
  struct Part {
    std::vector<Index> columns;
    std::vector<double> values;
  };
  const Index n = groups.count();
  RowMatrix result;
  result.diagonal.assign(n, 0);
  result.offsets.assign(n + 1, 0);
  std::vector<Part> parts(block_count(n));
  tbb::enumerable_thread_specific<std::vector<Index>> places([n] { return std::vector<Index>(n, none); });
  for_each_block(n, [&](Index block, Index begin, Index end) {
    Part& part = parts[block];
    std::vector<Index>& place = places.local();  // of a column in `part`, while its row is gathered
    for (Index row = begin; row < end; ++row) {
      const std::size_t first = part.columns.size();
      double diagonal = 0;
      for (Index m = groups.offsets[row]; m < groups.offsets[row + 1]; ++m) {
        const Index i = groups.members[m];
        diagonal += a.diagonal[i];
        for (Index e = a.offsets[i]; e < a.offsets[i + 1]; ++e) {
          const Index column = groups.of[a.columns[e]];
          if (column == row) {
            diagonal += a.values[e];
          } else if (place[column] == none) {
            place[column] = static_cast<Index>(part.columns.size());
            part.columns.push_back(column);
            part.values.push_back(a.values[e]);
          } else {
            part.values[place[column]] += a.values[e];
          }
        }
      }
      double others = 0;
      for (std::size_t e = first; e < part.columns.size(); ++e) {
        place[part.columns[e]] = none;
        others -= part.values[e];
      }
      // Rounding must not end the dominance.
      result.diagonal[row] = std::max(diagonal, others);
      result.offsets[row + 1] = static_cast<Index>(part.columns.size() - first);
    }
  });
  for (Index i = 0; i < n; ++i) result.offsets[i + 1] += result.offsets[i];
  result.columns.reserve(result.offsets.back());
  result.values.reserve(result.offsets.back());
  for (const Part& part : parts) {
    result.columns.insert(result.columns.end(), part.columns.begin(), part.columns.end());
    result.values.insert(result.values.end(), part.values.begin(), part.values.end());
  }
  return result;
}

}  // namespace

Grouping group_rows(const RowMatrix& matrix) {
  const Groups pairs = pair_rows(matrix);
  const RowMatrix between = summed(matrix, pairs);
  const Groups pairs_of_pairs = pair_rows(between);
  return {composed(pairs, pairs_of_pairs), summed(between, pairs_of_pairs)};
}

}  // namespace rimline
