// SPDX-License-Identifier: GPL-3.0-or-later
// The canvas of pictures: panels side by side, rasters within them.
#pragma once

#include <cairo.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "raster.h"
#include "rimline/points.h"

namespace rimline::cli {

constexpr int panel = 620;  // width and height of a panel's drawing; all lengths are for this size
constexpr int inset = 24;   // left free around what is drawn
constexpr int head = 76;    // above the drawing, for the title
constexpr int fine = 2;     // image pixels per pixel, each way
constexpr int gap = 20;     // between panels

constexpr Colour ink = {0.13, 0.15, 0.18};
constexpr Colour faint = {0.45, 0.48, 0.52};

inline Point finer(Point p) { return fine * p; }

// Transforms a plane with y up to the pixels of a panel, y down.
struct Fit {
  double scale = 1, x0 = 0, y0 = 0;

  Point place(Point p) const { return {scale * p.x + x0, y0 - scale * p.y, scale * p.z}; }
};

// The map of what is finite into the square panel but for its inset.
Fit fit(const std::vector<Point>& projected);

void set_colour(cairo_t* cairo, Colour colour, double alpha = 1);
// A raster of `fine` pixels per pixel, at the origin.
void paint(cairo_t* cairo, const Raster& raster);
void write_title(cairo_t* cairo, const std::string& title, const std::string& note);

// A square image of opaque or empty pixels (0xAARRGGBB, row by row) as the bytes of a PNG.
std::string png_of(std::vector<std::uint32_t> pixels, int size);

// PNG or SVG by the ending, `scale` times as large as drawn. Throws CannotWrite.
void write_drawing(const std::string& path, int width, int height, double scale,
                   const std::function<void(cairo_t*)>& draw);

}  // namespace rimline::cli
