// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "io/files.h"

namespace rimline {
namespace {

std::string names(const Cloud& cloud) {
  std::string result;
  for (const Column& column : cloud.columns) {
    result += (result.empty() ? "" : " ") + column.name + ":" + name(column.type);
  }
  return result;
}

const std::vector<Point> two = {{1.5, -2, 3e-3}, {4, 5, 6}};

TEST_CASE("all separators, comments, blank lines and line ends give the same points") {
  for (const std::string text : {"1.5 -2 3e-3\n4 5 6\n", "1.5,-2,3e-3\n4,5,6", "1.5;-2;3e-3\r\n4 ; 5;6\r\n",
                                 "\t1.5\t-2\t.003\n\n  4 5 6  \n\n",
                                 "# head\n1.5, -2, 3e-3\n// note\n4, 5, 6\n", "1.5 -2 3e-3\r4 5 6\r",
                                 "\xef\xbb\xbf"
                                 "1.5,-2,+3e-3,\n4,5,6,\n",
                                 "2\n1.5 -2 3e-3\n4 5 6\n"}) {
    CAPTURE(text);
    const Cloud cloud = read_bytes("a.xyz", text);
    CHECK(cloud.points == two);
    CHECK(cloud.columns.empty());
    CHECK(cloud.coordinate_type == Scalar::Float64);
  }
}

TEST_CASE("numbers are read to the nearest double") {
  const Cloud cloud =
      read_bytes("a.txt", "0.1 500000.123456789 9007199254740993\n1e-320 1.7976931348623157e308 nan\n");
  CHECK(cloud.points[0] == Point{0.1, 500000.123456789, 9007199254740992.0});
  CHECK(cloud.points[1].x == 1e-320);
  CHECK(std::isnan(cloud.points[1].z));
}

TEST_CASE("a header names the columns, in any order and case") {
  const Cloud cloud =
      read_bytes("a.csv", "Z,\"Y\",X,Scan angle,R,g,B\n3,2,1,0.5,0,128,255\n6,5,4,0.25,1,2,3\n");
  CHECK(cloud.points == std::vector<Point>{{1, 2, 3}, {4, 5, 6}});
  CHECK(names(cloud) == "Scan_angle:double red:uchar green:uchar blue:uchar");
  CHECK(values(cloud, "green") == std::vector<double>{128, 2});
}

TEST_CASE("a comment above the numbers names the columns if it fits them") {
  CHECK(names(read_bytes("a.txt", "//X Y Z Time\n1 2 3 4\n")) == "Time:double");
  CHECK(names(read_bytes("a.txt", "# a cloud of x y and z\n1 2 3 4\n")) == "intensity:double");
}

TEST_CASE("columns without a header are named by what they hold") {
  CHECK(names(read_bytes("a", "1 2 3 40\n")) == "intensity:double");
  CHECK(names(read_bytes("a", "1 2 3 0 0.6 -0.8\n4 5 6 0 0 0\n")) == "nx:double ny:double nz:double");
  CHECK(names(read_bytes("a", "1 2 3 0 10 255\n")) == "red:uchar green:uchar blue:uchar");
  CHECK(names(read_bytes("a", "1 2 3 0 10 256\n")) == "column_4:double column_5:double column_6:double");
  CHECK(names(read_bytes("a", "1\n1 2 3 -700 10 20 30\n")) ==
        "intensity:double red:uchar green:uchar blue:uchar");
  CHECK(names(read_bytes("a", "1 2 3 7 8\n")) == "column_4:double column_5:double");
  CHECK(names(read_bytes("a", "1 2 3 9 8 7 0 0 1\n")) ==
        "red:uchar green:uchar blue:uchar nx:double ny:double nz:double");
}

TEST_CASE("bad lines of text are named with the remedy") {
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5\n"),
                 "a.xyz, line 2: has 2 values where the lines before have 3"));
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5 6 7\n"), "line 2: has 4 values"));
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5 six\n"), "line 2: 'six' is not a number"));
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5 6x\n"), "line 2: '6x' is not a number"));
  CHECK(contains(complaint("a.csv", "1,2,3\n4,,6\n"), "line 2: value 2 is empty"));
  CHECK(contains(complaint("a.csv", "1,5;2,5;3,5\n"), "decimal points"));
  CHECK(contains(complaint("a.xyz", "1,5 2,5 3,5\n"), "decimal points"));
  CHECK(contains(complaint("a.xyz", "1 2 3\n1,5 2,5 3\n"), "line 2: numbers with decimal commas"));
  CHECK(contains(complaint("a.xyz", "1 2\n"), "line 1: has 2 values; a point needs at least x, y and z"));
  CHECK(contains(complaint("a.xyz", "east north up\n1 2 3\n"), "line 1: 'east north up' is neither"));
  CHECK(contains(complaint("a.xyz", "x y z i\n1 2 3\n"),
                 "line 2: has 3 values where the header names 4 columns"));
  CHECK(contains(complaint("a.xyz", "3\n1 2 3\n4 5 6\n"), "announces 3 points, but 2 follow"));
  CHECK(contains(complaint("a.xyz", "# nothing\n\n"), "no line of numbers"));
}

}  // namespace
}  // namespace rimline
