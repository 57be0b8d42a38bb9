// SPDX-License-Identifier: GPL-3.0-or-later
// A surface given by a formula: one chart, the part of it that is kept, and the curves that bound that part.
#pragma once

#include <functional>
#include <vector>

#include "rimline/points.h"
#include "rimline/sample.h"

namespace rimline {

struct Box {
  UV low, high;
  double width() const { return high.u - low.u; }
  double height() const { return high.v - low.v; }
};

struct Tangents {
  Point u, v;  // the derivatives of AnalyticSurface::at

  double area() const { return norm(cross(u, v)); }  // of the surface, for a unit of the chart
};

// A smooth piece of a boundary curve in the chart, for t from 0 to 1.
using Arc = std::function<UV(double t)>;
// Arcs head to tail, closed, with the surface on the left; its normal is cross(tangent u, tangent v).
using Rim = std::vector<Arc>;

// How the rows v = const of a grid follow the chart.
enum class Rows {
  Even,  // the chart is in units of length: all rows take the same steps in u
  Rings  // circles about an axis: the steps in u follow the circumference; v is in units of length
};

// What bounds the box at v = low and v = high.
enum class End { Open, Pole, Periodic };

struct AnalyticSurface {
  std::function<Point(UV)> at;
  std::function<Tangents(UV)> tangents;
  // Positive where the surface is. Outside it changes by at most one per unit of the chart, so that a cell
  // whose centre lies deeper outside than its half diagonal holds nothing.
  std::function<double(UV)> depth;
  // How far the point lies on the way across the patch, from 0 to 1: what a change of density follows.
  std::function<double(UV)> across;
  // A one to one map of the surface to the plane, nearly conformal, that keeps the orientation: where its
  // Delaunay triangulation is found. Within `in_window` only.
  std::function<UV(UV)> plane;
  std::function<bool(UV)> in_window = [](UV) { return true; };
  Box box;
  bool periodic_u = false;
  bool twisted = false;  // the seam joins (high u, v) to (low u, -v)
  End low_end = End::Open, high_end = End::Open;
  Rows rows = Rows::Even;
  std::vector<Rim> rims;  // the outer one first
};

// The surface of that name, about one unit in size. A margin > 0 moves each boundary outwards by as much in
// units of length (holes are filled): the larger patch that a crop starts from.
AnalyticSurface make_surface(Shape shape, double margin = 0);

AnalyticSurface flat_disc(double margin);
AnalyticSurface bumpy_square(double margin);
AnalyticSurface wavy_saddle(double margin);
AnalyticSurface square_with_holes(double margin);
AnalyticSurface half_tunnel(double margin);
AnalyticSurface curled_strip(double margin);
AnalyticSurface pipe(double margin);
AnalyticSurface hemisphere_cap(double margin);
AnalyticSurface sphere_minus_cap(double margin);
AnalyticSurface closed_sphere();
AnalyticSurface capped_tube(double margin);
AnalyticSurface torus_minus_cap(double margin);
AnalyticSurface moebius_strip(double margin);

// The pieces that surfaces are made of.
Arc straight(UV from, UV to);
// Counter-clockwise for turn = 1, clockwise for turn = -1.
Arc circle(UV centre, double radius, int turn);
Rim around(const Box& box);
double depth_in(const Box& box, UV at);
Box grown(const Box& box, double margin);

}  // namespace rimline
