// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "canvas.h"
#include "raster.h"

namespace rimline::cli {
namespace {

// The value of full colour: all bits of an integer, or 8 where no value is larger; 1 for other types, or the
// maximum.
double full_colour(const std::array<const Column*, 3>& columns, std::size_t points) {
  if (columns[0]->type == Scalar::UInt8) return 255;
  double most = 0;
  for (const Column* column : columns) {
    for (std::size_t i = 0; i < points; ++i) {
      const double value = column->value(static_cast<Index>(i));
      if (std::isfinite(value)) most = std::max(most, value);
    }
  }
  const bool whole = columns[0]->type != Scalar::Float32 && columns[0]->type != Scalar::Float64;
  if (most <= 1 && !whole) return 1;
  return most <= 255 ? 255 : 65535;
}

std::array<const Column*, 3> colours_of(const Cloud& cloud) {
  return {cloud.find("red"), cloud.find("green"), cloud.find("blue")};
}

bool has_colours(const Cloud& cloud) {
  const auto columns = colours_of(cloud);
  return std::ranges::all_of(columns, [](const Column* column) { return column != nullptr; });
}

std::vector<Colour> colours_of_points(const Cloud& cloud) {
  const auto columns = colours_of(cloud);
  const std::size_t points = cloud.points.size();
  const double full = full_colour(columns, points);
  std::vector<Colour> colours;
  for (Index i = 0; i < static_cast<Index>(points); ++i) {
    const auto share = [&](int c) {
      const double value = columns[c]->value(i) / full;
      return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0;
    };
    colours.push_back({share(0), share(1), share(2)});
  }
  return colours;
}

// From black to white.
std::vector<Colour> shades_of(const Column& column, std::size_t points) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < points; ++i) {
    const double value = column.value(static_cast<Index>(i));
    if (!std::isfinite(value)) continue;
    low = std::min(low, value), high = std::max(high, value);
  }
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < points; ++i) {
    const double value = column.value(static_cast<Index>(i));
    const double share = high > low && std::isfinite(value) ? (value - low) / (high - low) : 0;
    colours.push_back({share, share, share});
  }
  return colours;
}

// Fills empty pixels beside filled ones with the mean of their neighbours.
std::vector<std::uint32_t> bled(std::vector<std::uint32_t> pixels, int size) {
  constexpr int rings = 4;
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<std::uint32_t> before = pixels;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const std::size_t at = static_cast<std::size_t>(y) * size + x;
        if (before[at] != 0) continue;
        std::array<std::uint32_t, 3> sum{};
        std::uint32_t count = 0;
        for (int v = std::max(0, y - 1); v <= std::min(size - 1, y + 1); ++v) {
          for (int u = std::max(0, x - 1); u <= std::min(size - 1, x + 1); ++u) {
            const std::uint32_t pixel = before[static_cast<std::size_t>(v) * size + u];
            if (pixel == 0) continue;
            ++count;
            for (int c = 0; c < 3; ++c) sum[c] += (pixel >> (8 * c)) & 255;
          }
        }
        if (count == 0) continue;
        pixels[at] = 0xff000000;
        for (int c = 0; c < 3; ++c) pixels[at] |= (sum[c] / count) << (8 * c);
      }
    }
  }
  return pixels;
}

}  // namespace

void check_texture(const Cloud& cloud, const std::string& property) {
  if (property.empty() && !has_colours(cloud)) {
    throw Error(
        ErrorCode::BadOption,
        "--texture-size: the points have no colours (red, green, blue); name one of their properties with "
        "--texture-property");
  }
  if (!property.empty() && cloud.find(property) == nullptr)
    throw Error(ErrorCode::BadOption, "--texture-property: the points have no property '" + property + "'");
}

std::string bake_texture(const Cloud& cloud, const ReconstructResult& result, const std::string& property,
                         int size, const Run& run) {
  const std::vector<Colour> colours =
      property.empty() ? colours_of_points(cloud) : shades_of(*cloud.find(property), cloud.points.size());
  Raster raster(size, size);
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    if (t % 65536 == 0) run.check_cancel();
    std::array<Point, 3> place;
    for (int c = 0; c < 3; ++c) {
      const UV at = corner_uv(result.uv, result.seams, result.triangles, t, c);
      place[c] = {size * at.u, size * (1 - at.v), 0};
    }
    if (!is_finite(place[0]) || !is_finite(place[1]) || !is_finite(place[2])) continue;
    const Colour a = colours[result.triangles[t][0]], b = colours[result.triangles[t][1]],
                 c = colours[result.triangles[t][2]];
    raster.triangle(place[0], place[1], place[2], [&](double wb, double wc) {
      const double wa = 1 - wb - wc;
      return Colour{wa * a.r + wb * b.r + wc * c.r, wa * a.g + wb * b.g + wc * c.g,
                    wa * a.b + wb * b.b + wc * c.b};
    });
  }
  return png_of(bled(raster.pixels(), size), size);
}

}  // namespace rimline::cli
