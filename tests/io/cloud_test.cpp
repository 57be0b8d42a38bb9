// SPDX-License-Identifier: GPL-3.0-or-later
#include "rimline/cloud.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>

namespace rimline {
namespace {

template <class T>
void check_extremes(const char* type) {
  const std::vector<T> values = {std::numeric_limits<T>::lowest(), T{0}, std::numeric_limits<T>::max()};
  const Column column = make_column("c", values);
  CHECK(std::string(name(column.type)) == type);
  CHECK(column.bytes.size() == 3 * sizeof(T));
  for (Index i = 0; i < 3; ++i)
    CHECK(column.value(i) == static_cast<double>(values[static_cast<std::size_t>(i)]));
}

TEST_CASE("a column gives back the smallest and the largest number of every type") {
  check_extremes<std::int8_t>("char");
  check_extremes<std::uint8_t>("uchar");
  check_extremes<std::int16_t>("short");
  check_extremes<std::uint16_t>("ushort");
  check_extremes<std::int32_t>("int");
  check_extremes<std::uint32_t>("uint");
  check_extremes<float>("float");
  check_extremes<double>("double");
}

TEST_CASE("a raster is there where columns and rows are whole numbers from 0, of one scan") {
  Cloud cloud;
  cloud.points.resize(2);
  CHECK(cloud.raster().empty());
  set_column(cloud, make_column("column", std::vector<double>{3, 2147483646}));
  CHECK(cloud.raster().empty());
  set_column(cloud, make_column("row", std::vector<std::uint8_t>{7, 0}));
  REQUIRE(cloud.raster().size() == 2);
  CHECK(cloud.raster()[0].column == 3);
  CHECK(cloud.raster()[0].row == 7);
  CHECK(cloud.raster()[1].column == 2147483646);
  set_column(cloud, make_column("scan", std::vector<std::uint16_t>{1, 1}));
  CHECK(cloud.raster().size() == 2);
  set_column(cloud, make_column("scan", std::vector<std::uint16_t>{0, 1}));
  CHECK(cloud.raster().empty());
  for (const double wrong : {-1.0, 0.5, 2147483647.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    Cloud other;
    other.points.resize(2);
    set_column(other, make_column("row", std::vector<double>{0, 1}));
    set_column(other, make_column("column", std::vector<double>{0, wrong}));
    CAPTURE(wrong);
    CHECK(other.raster().empty());
  }
}

TEST_CASE("a column that is set replaces the one of its name and keeps its place") {
  Cloud cloud;
  set_column(cloud, make_column("boundary", std::vector<double>{1}));
  set_column(cloud, make_column("intensity", std::vector<double>{2}));
  set_column(cloud, make_column("boundary", std::vector<std::uint8_t>{0}));
  REQUIRE(cloud.columns.size() == 2);
  CHECK(cloud.columns[0].name == "boundary");
  CHECK(cloud.columns[0].type == Scalar::UInt8);
  CHECK(cloud.columns[0].value(0) == 0);
}

TEST_CASE("a cloud has normals only where all three columns are there") {
  Cloud cloud;
  cloud.points = {{0, 0, 0}};
  set_column(cloud, make_column("nx", std::vector<float>{0.5f}));
  set_column(cloud, make_column("ny", std::vector<float>{0.25f}));
  CHECK(cloud.normals().empty());
  set_column(cloud, make_column("nz", std::vector<double>{-1}));
  CHECK(cloud.normals() == std::vector<Point>{{0.5, 0.25, -1}});
}

}  // namespace
}  // namespace rimline
