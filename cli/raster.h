// SPDX-License-Identifier: GPL-3.0-or-later
// A small image with a depth buffer.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "rimline/points.h"

namespace rimline::cli {

// Red, green and blue from 0 to 1.
struct Colour {
  double r = 0, g = 0, b = 0;
};

Colour mix(Colour a, Colour b, double share_of_b);

// Pixels count from the left and from the top; z grows toward the eye.
class Raster {
 public:
  Raster(int width, int height);

  // A disc that faces the eye; drawn where it is nearer than what is there.
  void disc(Point centre, double radius, Colour colour);
  // The same for depth alone: it hides what is behind and draws nothing.
  void screen(Point centre, double radius);
  void triangle(Point a, Point b, Point c, Colour colour);
  // The same, its colour depending on the place: weights of b and of c, from 0 to 1.
  void triangle(Point a, Point b, Point c, const std::function<Colour(double, double)>& colour);
  // Whether a point at this place would be seen.
  bool sees(Point p, double tolerance) const;

  int width() const { return width_; }
  int height() const { return height_; }
  // Premultiplied 0xAARRGGBB, row by row; transparent where nothing was drawn.
  const std::vector<std::uint32_t>& pixels() const { return pixels_; }

 private:
  template <class ColourAt>
  void fill(Point a, Point b, Point c, const ColourAt& colour_at);
  template <class Visit>
  void visit_disc(Point centre, double radius, const Visit& visit);

  int width_, height_;
  std::vector<std::uint32_t> pixels_;
  std::vector<float> depth_;
};

}  // namespace rimline::cli
