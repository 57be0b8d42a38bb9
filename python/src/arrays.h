// SPDX-License-Identifier: GPL-3.0-or-later
// Between vectors of the library and arrays of NumPy, without a copy in either direction.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rimline/given.h"
#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::python {

namespace nb = nanobind;

// What the package hands over: checked and converted there (python/rimline/_arrays.py), so that these match.
template <class T, nb::ssize_t columns>
using Rows = nb::ndarray<const T, nb::numpy, nb::shape<-1, columns>, nb::c_contig, nb::device::cpu>;
template <class T>
using List = nb::ndarray<const T, nb::numpy, nb::shape<-1>, nb::c_contig, nb::device::cpu>;
using PointRows = Rows<double, 3>;
using UvRows = Rows<double, 2>;
using TriangleRows = Rows<Index, 3>;

// What is handed to Python: the stubs tell its type and shape.
template <class Number, nb::ssize_t... shape>
using Array = nb::ndarray<nb::numpy, Number, nb::shape<shape...>>;

// An item of a vector as a row of numbers, and an array of such rows.
template <class T>
struct Row {
  using Number = T;
  static constexpr std::size_t columns = 1;
  template <class N>
  using Rows = Array<N, -1>;
};
template <class T, int n>
struct LongRow {
  using Number = T;
  static constexpr std::size_t columns = n;
  template <class N>
  using Rows = Array<N, -1, n>;
};
template <>
struct Row<Point> : LongRow<double, 3> {};
template <>
struct Row<UV> : LongRow<double, 2> {};
template <class T, std::size_t n>
struct Row<std::array<T, n>> : LongRow<T, static_cast<int>(n)> {};
static_assert(sizeof(Point) == 3 * sizeof(double) && sizeof(UV) == 2 * sizeof(double));

// Containers whose items the stubs call Any.
using Dict = nb::typed<nb::dict, nb::str, nb::any>;

// Cloud::raster() of the columns `column`, `row` and `scan`; in files.cpp.
std::vector<RasterCell> raster_of(const Dict& columns, std::size_t rows);
using Items = nb::typed<nb::list, nb::any>;
using Several = nb::typed<nb::tuple, nb::any, nb::ellipsis>;

// Views of what NumPy holds.
inline Points as_points(const PointRows& rows) {
  return {reinterpret_cast<const Point*>(rows.data()), rows.shape(0)};
}
inline std::span<const UV> as_uv(const UvRows& rows) {
  return {reinterpret_cast<const UV*>(rows.data()), rows.shape(0)};
}
template <class T>
std::span<const T> as_span(const List<T>& list) {
  return {list.data(), list.shape(0)};
}
// A copy, where the library wants a vector.
std::vector<Triangle> as_triangles(const TriangleRows& rows);

// An array of `count` items over memory that `owner` keeps; it keeps `owner`.
template <class T, class Number>
auto array_over(Number* data, std::size_t count, nb::handle owner) {
  using Rows = typename Row<T>::template Rows<Number>;
  const std::array<std::size_t, 2> shape{count, Row<T>::columns};
  return Rows(data, Row<T>::columns == 1 ? 1 : 2, shape.data(), owner);
}

// The vector's memory as an array, which frees it with its last view.
template <class Vector>
auto give(Vector&& values) {
  using Whole = std::remove_cvref_t<Vector>;
  using Item = typename Whole::value_type;
  auto* kept = new Whole(std::forward<Vector>(values));
  const nb::capsule owner(kept, [](void* memory) noexcept { delete static_cast<Whole*>(memory); });
  return array_over<Item>(reinterpret_cast<typename Row<Item>::Number*>(kept->data()), kept->size(), owner);
}

// A read-only array over a member of a bound object, which lives as long as the array.
template <class Vector>
auto view_of(const Vector& values, nb::handle owner) {
  using Item = typename Vector::value_type;
  return array_over<Item>(reinterpret_cast<const typename Row<Item>::Number*>(values.data()), values.size(),
                          owner);
}

}  // namespace rimline::python
