// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rimline::cli {
namespace {

std::uint32_t packed(Colour colour) {
  const auto channel = [](double value) {
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  return 0xff000000U | channel(colour.r) << 16 | channel(colour.g) << 8 | channel(colour.b);
}

}  // namespace

Colour mix(Colour a, Colour b, double share_of_b) {
  const double t = std::clamp(share_of_b, 0.0, 1.0);
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

Raster::Raster(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * height, 0),
      depth_(static_cast<std::size_t>(width) * height, -std::numeric_limits<float>::infinity()) {}

template <class Visit>
void Raster::visit_disc(Point centre, double radius, const Visit& visit) {
  const int left = std::max(0, static_cast<int>(std::ceil(centre.x - radius - 0.5)));
  const int right = std::min(width_ - 1, static_cast<int>(std::floor(centre.x + radius - 0.5)));
  const int top = std::max(0, static_cast<int>(std::ceil(centre.y - radius - 0.5)));
  const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(centre.y + radius - 0.5)));
  const auto z = static_cast<float>(centre.z);
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const double dx = x + 0.5 - centre.x, dy = y + 0.5 - centre.y;
      const std::size_t pixel = static_cast<std::size_t>(y) * width_ + x;
      if (dx * dx + dy * dy <= radius * radius && z >= depth_[pixel]) visit(pixel, z);
    }
  }
}

void Raster::disc(Point centre, double radius, Colour colour) {
  const std::uint32_t value = packed(colour);
  visit_disc(centre, radius, [&](std::size_t pixel, float z) {
    pixels_[pixel] = value;
    depth_[pixel] = z;
  });
}

void Raster::screen(Point centre, double radius) {
  visit_disc(centre, radius, [&](std::size_t pixel, float z) { depth_[pixel] = z; });
}

template <class ColourAt>
void Raster::fill(Point a, Point b, Point c, const ColourAt& colour_at) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0 || !std::isfinite(area)) return;
  const int left = std::max(0, static_cast<int>(std::floor(std::min({a.x, b.x, c.x}))));
  const int right = std::min(width_ - 1, static_cast<int>(std::ceil(std::max({a.x, b.x, c.x}))));
  const int top = std::max(0, static_cast<int>(std::floor(std::min({a.y, b.y, c.y}))));
  const int bottom = std::min(height_ - 1, static_cast<int>(std::ceil(std::max({a.y, b.y, c.y}))));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double wb = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
      const double wc = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
      if (wb < 0 || wc < 0 || wb + wc > 1) continue;
      const auto z = static_cast<float>(a.z + wb * (b.z - a.z) + wc * (c.z - a.z));
      const std::size_t pixel = static_cast<std::size_t>(y) * width_ + x;
      if (z < depth_[pixel]) continue;
      depth_[pixel] = z;
      pixels_[pixel] = colour_at(wb, wc);
    }
  }
}

void Raster::triangle(Point a, Point b, Point c, Colour colour) {
  const std::uint32_t value = packed(colour);
  fill(a, b, c, [value](double, double) { return value; });
}

void Raster::triangle(Point a, Point b, Point c, const std::function<Colour(double, double)>& colour) {
  fill(a, b, c, [&](double wb, double wc) { return packed(colour(wb, wc)); });
}

bool Raster::sees(Point p, double tolerance) const {
  const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return true;
  return p.z + tolerance >= depth_[static_cast<std::size_t>(y) * width_ + x];
}

}  // namespace rimline::cli
