// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/free_map.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "map/embed.h"

namespace rimline {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

// Two points of the loop about as far apart as any: the farthest from the farthest from its first.
std::pair<Index, Index> far_pair(Points points, const std::vector<Index>& loop) {
  const auto farthest = [&](Index from) {
    return *std::max_element(loop.begin(), loop.end(), [&](Index a, Index b) {
      return squared_distance(points[a], points[from]) < squared_distance(points[b], points[from]);
    });
  };
  const Index a = farthest(loop.front());
  return {a, farthest(a)};
}

// The lower triangle of the conformal energy's matrix: unknown 2 i is u of vertex i, 2 i + 1 its v.
Entries conformal_energy(Points points, const Triangulation& mesh) {
  Entries entries;
  const auto add = [&](Index row, Index column, double value) {
    if (row >= column) entries.emplace_back(row, column, value);
  };
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const Index p = mesh.triangles[t][c], a = mesh.triangles[t][next(c)],
                  b = mesh.triangles[t][previous(c)];
      const Point e = points[a] - points[p], f = points[b] - points[p];
      const double size = norm(cross(e, f));
      const double weight = 0.5 * dot(e, f) / std::max(size, 1e-12 * (dot(e, e) + dot(f, f)));
      for (int k = 0; k < 2; ++k) {  // Dirichlet energy
        add(2 * a + k, 2 * a + k, weight);
        add(2 * b + k, 2 * b + k, weight);
        add(2 * std::max(a, b) + k, 2 * std::min(a, b) + k, -weight);
      }
      if (mesh.adjacent[t][c] != none) continue;
      // Less the area, half of which is the cross product along each boundary edge from a to b.
      for (const auto& [u, v, sign] : {std::tuple{2 * a, 2 * b + 1, -0.5}, {2 * b, 2 * a + 1, 0.5}}) {
        entries.emplace_back(std::max(u, v), std::min(u, v), sign);
      }
    }
  }
  return entries;
}

double area_of(Points points, const Triangulation& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += 0.5 * norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
  }
  return sum;
}

double area_of(const Triangulation& mesh, const std::vector<UV>& uv) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const UV a = uv[t[0]], b = uv[t[1]], c = uv[t[2]];
    sum += 0.5 * ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u));
  }
  return sum;
}

}  // namespace

MapSummary free_map(Points points, const Triangulation& mesh, const std::vector<Index>& outer_loop,
                    std::vector<UV>& uv, const Run& run) {
  run.check_cancel();
  const Index n = static_cast<Index>(uv.size());
  const auto [left, right] = far_pair(points, outer_loop);
  std::vector<Index> unknown(2 * n, none);
  Index count = 0;
  for (Index i = 0; i < 2 * n; ++i) {
    if (i / 2 != left && i / 2 != right) unknown[i] = count++;
  }
  std::vector<double> held(2 * n, 0);
  held[2 * right] = distance(points[left], points[right]);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(count);
  Entries kept;
  for (const Eigen::Triplet<double>& e : conformal_energy(points, mesh)) {
    const Index i = unknown[e.row()], j = unknown[e.col()];
    if (i != none && j != none) kept.emplace_back(i, j, e.value());
    if (i != none && j == none) b[i] -= e.value() * held[e.col()];
    if (i == none && j != none) b[j] -= e.value() * held[e.row()];
  }
  Matrix lower(count, count);
  lower.setFromTriplets(kept.begin(), kept.end());
  const Eigen::SimplicialLDLT<Matrix> factor(lower);
  if (factor.info() != Eigen::Success) {
    throw Error(ErrorCode::NoConvergence, "the system of the free map could not be factorized");
  }
  run.check_cancel();
  Eigen::VectorXd x = factor.solve(b);
  x += factor.solve(b - lower.selfadjointView<Eigen::Lower>() * x);  // once refined
  MapSummary summary;
  summary.unknowns = static_cast<std::size_t>(count);
  summary.residual = (b - lower.selfadjointView<Eigen::Lower>() * x).norm() / std::max(b.norm(), 1e-300);
  for (Index i = 0; i < n; ++i) {
    const auto value = [&](Index k) { return unknown[k] == none ? held[k] : x[unknown[k]]; };
    uv[i] = {value(2 * i), value(2 * i + 1)};
  }
  scale_to_area(points, mesh, uv);
  return summary;
}

void scale_to_area(Points points, const Triangulation& mesh, std::vector<UV>& uv) {
  const double scale = std::sqrt(area_of(points, mesh) / std::max(area_of(mesh, uv), 1e-300));
  for (UV& p : uv) p = {scale * p.u, scale * p.v};
}

void add_caps(const std::vector<Loop>& loops, std::vector<Point>& points, Triangulation& mesh) {
  std::vector<Triangle> triangles = std::move(mesh.triangles);
  for (std::size_t h = 1; h < loops.size(); ++h) {
    const std::vector<Index>& rim = loops[h].points;
    Point centre;
    for (const Index v : rim) centre = centre + (1 / static_cast<double>(rim.size())) * points[v];
    const Index id = static_cast<Index>(points.size());
    points.push_back(centre);
    for (std::size_t i = 0; i < rim.size(); ++i) triangles.push_back({rim[(i + 1) % rim.size()], rim[i], id});
  }
  mesh = triangulation_of(std::move(triangles), static_cast<Index>(points.size()));
}

std::size_t unflip(const Triangulation& mesh, std::vector<UV>& uv, const Run& run) {
  constexpr int attempts = 12;
  std::vector<char> rim(uv.size(), 0);
  for (Index t = 0; t < mesh.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      if (mesh.adjacent[t][c] == none)
        rim[mesh.triangles[t][next(c)]] = rim[mesh.triangles[t][previous(c)]] = 1;
    }
  }
  std::vector<char> moved(uv.size(), 0);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const std::vector<Index> flipped = flipped_triangles(mesh.triangles, uv, run);
    if (flipped.empty()) return 0;
    for (const Index t : flipped) {
      for (const Index v : mesh.triangles[t]) moved[v] = 1;
    }
    if (attempt > 0) {  // one more ring about what did not suffice
      const std::vector<char> before = moved;
      for (const Triangle& t : mesh.triangles) {
        if (before[t[0]] || before[t[1]] || before[t[2]]) moved[t[0]] = moved[t[1]] = moved[t[2]] = 1;
      }
    }
    std::vector<UV> sum(uv.size());
    std::vector<int> valence(uv.size());
    constexpr int sweeps = 60;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      std::fill(sum.begin(), sum.end(), UV{});
      std::fill(valence.begin(), valence.end(), 0);
      for (const Triangle& t : mesh.triangles) {
        if (!(moved[t[0]] || moved[t[1]] || moved[t[2]])) continue;
        for (int c = 0; c < 3; ++c) {
          for (const int o : {next(c), previous(c)}) {
            sum[t[c]] = {sum[t[c]].u + uv[t[o]].u, sum[t[c]].v + uv[t[o]].v};
            ++valence[t[c]];
          }
        }
      }
      for (std::size_t v = 0; v < uv.size(); ++v) {
        if (moved[v] && !rim[v]) uv[v] = {sum[v].u / valence[v], sum[v].v / valence[v]};
      }
    }
  }
  return flipped_triangles(mesh.triangles, uv, run).size();
}

std::size_t count_crossings(const std::vector<Index>& loop, const std::vector<UV>& uv) {
  struct Edge {
    std::size_t at;
    UV a, b;
    double low;
  };
  const std::size_t n = loop.size();
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < n; ++i) {
    const UV a = uv[loop[i]], b = uv[loop[i + 1 < n ? i + 1 : 0]];
    edges.push_back({i, a, b, std::min(a.u, b.u)});
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return std::tie(e.low, e.at) < std::tie(f.low, f.at); });
  const auto side = [](UV a, UV b, UV c) { return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u); };
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Edge& e = edges[i];
    for (std::size_t j = i + 1; j < n && edges[j].low <= std::max(e.a.u, e.b.u); ++j) {
      const Edge& f = edges[j];
      if (std::max(e.a.v, e.b.v) < std::min(f.a.v, f.b.v) || std::max(f.a.v, f.b.v) < std::min(e.a.v, e.b.v))
        continue;
      const std::size_t gap = e.at > f.at ? e.at - f.at : f.at - e.at;
      if (gap == 1 || gap == n - 1) continue;  // neighbours share an end
      crossings +=
          side(e.a, e.b, f.a) * side(e.a, e.b, f.b) <= 0 && side(f.a, f.b, e.a) * side(f.a, f.b, e.b) <= 0;
    }
  }
  return crossings;
}

}  // namespace rimline
