// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of known topology, wound from grids.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::shapes {

struct Mesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

// Vertex (i, j) has the id `id(i, j)`; the cell between it and (i + 1, j + 1) has two triangles.
template <class Id>
std::vector<Triangle> cells(int columns, int rows, const Id& id) {
  std::vector<Triangle> triangles;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return triangles;
}

inline Mesh torus(int about, int through, double large, double small) {
  Mesh mesh;
  for (int j = 0; j < through; ++j) {
    for (int i = 0; i < about; ++i) {
      const double a = 2 * std::numbers::pi * i / about, b = 2 * std::numbers::pi * j / through;
      const double r = large + small * std::cos(b);
      mesh.points.push_back({r * std::cos(a), r * std::sin(a), small * std::sin(b)});
    }
  }
  mesh.triangles = cells(about, through,
                         [=](int i, int j) { return static_cast<Index>(i % about + about * (j % through)); });
  return mesh;
}

// Surfaces of revolution about z: ring j of `about` points has the radius r(j) and the height z(j).
template <class Radius, class Height>
Mesh revolved(int about, int rings, const Radius& r, const Height& z) {
  Mesh mesh;
  for (int j = 0; j < rings; ++j) {
    for (int i = 0; i < about; ++i) {
      const double a = 2 * std::numbers::pi * (i + 0.5 * (j % 2)) / about;
      mesh.points.push_back({r(j) * std::cos(a), r(j) * std::sin(a), z(j)});
    }
  }
  mesh.triangles =
      cells(about, rings - 1, [=](int i, int j) { return static_cast<Index>(i % about + about * j); });
  return mesh;
}

// Of radius 1, with an edge length about 2 pi / about.
inline Mesh tube(int about, int rings) {
  const double step = 2 * std::numbers::pi / about;
  return revolved(
      about, rings, [](int) { return 1.0; }, [=](int j) { return step * j; });
}

// Two balls of radius about 1 with holes at their ends, and a neck between them.
constexpr double neck = 0.3;
inline Mesh dumbbell(int about, int rings) {
  const auto at = [=](int j) { return -1 + 2.0 * j / (rings - 1); };
  return revolved(
      about, rings,
      [=](int j) {
        const double z = 2 * at(j);
        return std::max(neck, std::sqrt(std::max(0.0, 1 - (std::abs(z) - 1) * (std::abs(z) - 1))));
      },
      [=](int j) { return 2 * at(j); });
}

// A ball of radius 1: an octahedron whose triangles are cut in four `times` times.
inline Mesh octahedron(int times) {
  Mesh mesh;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int k = 0; k < times; ++k) {
    std::vector<Triangle> finer;
    const auto middle = [&](Index a, Index b) {
      const Point sum = mesh.points[a] + mesh.points[b], p = (1 / norm(sum)) * sum;
      for (Index i = 0; i < static_cast<Index>(mesh.points.size()); ++i) {
        if (norm(mesh.points[i] - p) < 1e-9) return i;
      }
      mesh.points.push_back(p);
      return static_cast<Index>(mesh.points.size()) - 1;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
      const Index d = middle(b, c), e = middle(c, a), f = middle(a, b);
      finer.insert(finer.end(), {{a, f, e}, {f, b, d}, {e, d, c}, {d, e, f}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

// A strip with half a twist, one-sided.
inline Mesh moebius(int along, int across, double radius = 1, double width = 0.8) {
  Mesh mesh;
  for (int j = 0; j <= across; ++j) {
    for (int i = 0; i < along; ++i) {
      const double a = 2 * std::numbers::pi * i / along, w = -width / 2 + width * j / across;
      const double r = radius + w * std::cos(a / 2);
      mesh.points.push_back({r * std::cos(a), r * std::sin(a), w * std::sin(a / 2)});
    }
  }
  mesh.triangles = cells(along, across, [=](int i, int j) {
    const int row = i == along ? across - j : j;
    return static_cast<Index>(i % along + along * row);
  });
  return mesh;
}

// The surface of a square plate of 2 n + 1 cubes a side and one cube thick, with n x n square holes through
// it: n n handles on at most 8 (n + 1) (n + 1) points.
inline Mesh pierced_plate(int n) {
  const int size = 2 * n + 1, stride = size + 1;
  const auto solid = [&](int i, int j, int k) {
    return i >= 0 && j >= 0 && i < size && j < size && k == 0 && !(i % 2 == 1 && j % 2 == 1);
  };
  Mesh mesh;
  std::vector<Index> number(static_cast<std::size_t>(2 * stride * stride), none);
  const auto corner = [&](std::array<int, 3> at) {
    Index& id = number[static_cast<std::size_t>((at[2] * stride + at[1]) * stride + at[0])];
    if (id == none) {
      id = static_cast<Index>(mesh.points.size());
      mesh.points.push_back({1.0 * at[0], 1.0 * at[1], 1.0 * at[2]});
    }
    return id;
  };
  // The side of a cube across axis d, low or high, counter-clockwise from outside.
  const auto add_side = [&](std::array<int, 3> cube, int d, int high) {
    std::array<Index, 4> ring{};
    for (int s = 0; s < 4; ++s) {
      std::array<int, 3> at = cube;
      at[d] += high;
      at[(d + 1) % 3] += s == 1 || s == 2;
      at[(d + 2) % 3] += s >= 2;
      ring[high ? s : 3 - s] = corner(at);
    }
    mesh.triangles.push_back({ring[0], ring[1], ring[2]});
    mesh.triangles.push_back({ring[0], ring[2], ring[3]});
  };
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      if (!solid(i, j, 0)) continue;
      for (int d = 0; d < 3; ++d) {
        for (int high = 0; high < 2; ++high) {
          std::array<int, 3> beside{i, j, 0};
          beside[d] += high ? 1 : -1;
          if (!solid(beside[0], beside[1], beside[2])) add_side({i, j, 0}, d, high);
        }
      }
    }
  }
  return mesh;
}

// A ramp that winds so many times about an axis, at radii 1 to 2.
inline Mesh winding_ramp(int turns) {
  constexpr int about = 40, across = 4;
  Mesh mesh;
  for (int i = 0; i <= turns * about; ++i) {
    const double angle = 2 * std::numbers::pi * i / about;
    for (int j = 0; j <= across; ++j) {
      const double radius = 1 + 1.0 * j / across;
      mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.1 * angle});
    }
  }
  mesh.triangles = cells(across, turns * about, [](int j, int i) { return Index{i * (across + 1) + j}; });
  return mesh;
}

}  // namespace rimline::shapes
