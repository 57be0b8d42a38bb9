// SPDX-License-Identifier: GPL-3.0-or-later
#include "canvas.h"

#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

#include "outputs.h"
#include "rimline/io.h"

namespace rimline::cli {
namespace {

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

// The map of a box that fills the square panel but for its inset.
Fit fit(double left, double right, double bottom, double top) {
  const double room = panel - 2 * inset;
  Fit result;
  const double extent = std::max(right - left, top - bottom);
  result.scale = extent > 0 ? room / extent : 1;
  result.x0 = panel / 2.0 - result.scale * (left + right) / 2;
  result.y0 = panel / 2.0 + result.scale * (bottom + top) / 2;
  return result;
}

}  // namespace

Fit fit(const std::vector<Point>& projected) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double left = infinite, right = -infinite, bottom = infinite, top = -infinite;
  for (const Point p : projected) {
    if (!is_finite(p)) continue;
    left = std::min(left, p.x), right = std::max(right, p.x);
    bottom = std::min(bottom, p.y), top = std::max(top, p.y);
  }
  return left <= right ? fit(left, right, bottom, top) : Fit{};
}

void set_colour(cairo_t* cairo, Colour c, double alpha) {
  cairo_set_source_rgba(cairo, c.r, c.g, c.b, alpha);
}

void paint(cairo_t* cairo, const Raster& raster) {
  const Surface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, raster.width(), raster.height()),
                      &cairo_surface_destroy);
  cairo_surface_flush(image.get());
  unsigned char* to = cairo_image_surface_get_data(image.get());
  if (to == nullptr) throw std::bad_alloc();
  const int stride = cairo_image_surface_get_stride(image.get());
  for (int y = 0; y < raster.height(); ++y) {
    std::memcpy(to + static_cast<std::ptrdiff_t>(y) * stride,
                raster.pixels().data() + static_cast<std::size_t>(y) * raster.width(),
                sizeof(std::uint32_t) * raster.width());
  }
  cairo_surface_mark_dirty(image.get());
  cairo_save(cairo);
  cairo_scale(cairo, 1.0 / fine, 1.0 / fine);
  cairo_set_source_surface(cairo, image.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

void write_title(cairo_t* cairo, const std::string& title, const std::string& note) {
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
  cairo_set_font_size(cairo, 27);
  set_colour(cairo, ink);
  cairo_move_to(cairo, inset, 40);
  cairo_show_text(cairo, title.c_str());
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, 19);
  set_colour(cairo, faint);
  cairo_move_to(cairo, inset, 66);
  cairo_show_text(cairo, note.c_str());
}

std::string png_of(std::vector<std::uint32_t> pixels, int size) {
  std::string bytes;
  const Surface image(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                          CAIRO_FORMAT_ARGB32, size, size, 4 * size),
                      &cairo_surface_destroy);
  const cairo_status_t status = cairo_surface_write_to_png_stream(image.get(), append, &bytes);
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw Error(ErrorCode::CannotWrite, cairo_status_to_string(status));
  return bytes;
}

void write_drawing(const std::string& path, int width, int height, double scale,
                   const std::function<void(cairo_t*)>& draw) {
  const bool svg = ending_of(path) == "svg";
  std::string bytes;
  const Surface surface(
      svg ? cairo_svg_surface_create_for_stream(append, &bytes, scale * width, scale * height)
          : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(scale * width)),
                                       static_cast<int>(std::lround(scale * height))),
      &cairo_surface_destroy);
  const Context cairo(cairo_create(surface.get()), &cairo_destroy);
  cairo_scale(cairo.get(), scale, scale);
  draw(cairo.get());
  cairo_status_t status = cairo_status(cairo.get());
  if (!svg) status = std::max(status, cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  cairo_surface_finish(surface.get());
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) {
    throw Error(ErrorCode::CannotWrite, path + ": " + cairo_status_to_string(status));
  }
  write_text(path, bytes);
}

}  // namespace rimline::cli
