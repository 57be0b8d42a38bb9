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

TEST_CASE("decimal commas are read where something else parts the numbers") {
  const std::vector<Point> expected = {{1.5, -2, 0.003}, {4, 5, 6.25}};
  for (const std::string text :
       {"1,5;-2;3e-3\n4;5;6,25\n", "1,5\t-2,0\t0,003\n4\t5\t6,25\n", "1,5 -2,0 0,003\n4 5 6,25\n",
        "4;5;6,25\n", "X;Y;Z\r\n1,5;-2;0,003\r\n4;5;6,25\r\n", "x;y;z\n\"1,5\";\"-2\";\"0,003\"\n4;5;6,25\n",
        "x,y,z\n\"1,5\",-2,\"0,003\"\n4,5,\"6,25\"\n"}) {
    CAPTURE(text);
    const Cloud cloud = read_bytes("a.csv", text);
    CHECK(cloud.points.back() == expected.back());
    if (cloud.points.size() > 1) CHECK(cloud.points == expected);
    CHECK(cloud.columns.empty());
  }
  CHECK(read_bytes("a.csv", "1,5,2,5\n").columns.size() ==
        1);  // four numbers: nothing tells the commas apart
}

TEST_CASE("a header is understood in any case, language of survey and separator") {
  const std::vector<Point> expected = {{1, 2, 3}};
  for (const std::string text :
       {"X;Y;Z\n1;2;3\n", "NORTHING,EASTING,ELEVATION\n2,1,3\n", "Id\tx [mm]\ty [mm]\tz [mm]\n7\t1\t2\t3\n",
        "Points:0,Points:1,Points:2\n1,2,3\n", "POINT_X POINT_Y POINT_Z\n1 2 3\n", "east north up\n1 2 3\n",
        "# LATITUDE_LOW LONGITUDE_LOW LATITUDE_HIGH LONGITUDE_HIGH HEIGHT_LOW\n2 1 8 9 3\n"}) {
    CAPTURE(text);
    CHECK(read_bytes("a.csv", text).points == expected);
  }
  const Cloud millimetres = read_bytes("a.csv", "id;X [mm];Y [mm];Z [mm]\n7;1;2;3\n");
  CHECK(millimetres.unit == "mm");
  CHECK(millimetres.coordinates == "X [mm], Y [mm], Z [mm] (columns 2, 3 and 4)");
  CHECK(millimetres.warnings.empty());
}

TEST_CASE("columns of text under a header are left out, and a warning says which") {
  for (const std::string text : {"Name,X,Y,Z,Kind,i\nA1,1,2,3,old tree,7\nA 2,4,5,6,,8\n",
                                 "sep=;\nName;X;Y;Z;Kind;i\n\"A1\";1;2;3;x;7\nB;4;5;6;x y z;8\n",
                                 "Name X Y Z Kind i\nA1 1 2 3 x 7\n12 4 5 6 y 8\n"}) {
    CAPTURE(text);
    const Cloud cloud = read_bytes("a.csv", text);
    CHECK(cloud.points == std::vector<Point>{{1, 2, 3}, {4, 5, 6}});
    CHECK(values(cloud, "i") == std::vector<double>{7, 8});
    CHECK(cloud.columns.size() == 1);
    CHECK(cloud.coordinates == "x, y, z (columns 2, 3 and 4)");
    REQUIRE(cloud.warnings.size() == 1);
    CHECK(contains(cloud.warnings[0], "columns of text are left out: Name, Kind"));
  }
  CHECK(contains(complaint("a.csv", "name,x,y,z\na,1,b,3\n"), "line 2: 'a' is not a number"));
  CHECK(contains(complaint("a.csv", "name,x,y,z\na,1,2,3\nb,1,c,3\n"), "line 3: 'b' is not a number"));
}

TEST_CASE("nothing parts within quotes, in a header and in columns of text") {
  for (const std::string text : {"\"Name, full\",X,Y,Z\n\"Oak, old\",1,2,3\n\"Elm\",4,5,6\n",
                                 "X;Y;Z;\"Kind; more\"\n1;2;3;\"a;b; c\"\n\"4\";5;6;\"d\"\n",
                                 "X Y Z \"Kind of tree\"\n1 2 3 \"an oak\"\n4 5 6 \"an elm\"\n"}) {
    CAPTURE(text);
    const Cloud cloud = read_bytes("a.csv", text);
    CHECK(cloud.points == std::vector<Point>{{1, 2, 3}, {4, 5, 6}});
    CHECK(cloud.columns.empty());
  }
  CHECK_FALSE(complaint("a.csv", "X,Y,Z,\"Kind\n1,2,3,\"a,b\n").empty());  // quotes that do not close
}

TEST_CASE("a comment may start with a per cent sign, and name the columns") {
  const Cloud cloud = read_bytes("a.txt", "% made by hand\n% z y x i\n3 2 1 7\n6 5 4 8\n");
  CHECK(cloud.points == std::vector<Point>{{1, 2, 3}, {4, 5, 6}});
  CHECK(values(cloud, "i") == std::vector<double>{7, 8});
}

TEST_CASE("degrees are told, as no boundary can be trusted in them") {
  const Cloud cloud = read_bytes("a.csv", "lat,lon,height\n2,1,3\n");
  CHECK(cloud.points == std::vector<Point>{{1, 2, 3}});
  REQUIRE(cloud.warnings.size() == 1);
  CHECK(contains(cloud.warnings[0], "lon and lat, which are angles"));
}

std::string counted(int first, int rows) {
  std::string text;
  for (int i = 0; i < rows; ++i) text += std::to_string(first + i) + " " + std::to_string(0.5 * i) + " 7 8\n";
  return text;
}

TEST_CASE("a first column that counts the points is their id, and a warning says so") {
  const Cloud cloud = read_bytes("a.txt", counted(1, 12));
  CHECK(names(cloud) == "id:double");
  CHECK(cloud.points[2] == Point{1, 7, 8});
  CHECK(values(cloud, "id")[2] == 3);
  CHECK(cloud.coordinates == "columns 2, 3 and 4");
  REQUIRE(cloud.warnings.size() == 1);
  CHECK(contains(cloud.warnings[0], "were taken for id x y z, as the first column counts 1, 2, 3 ..."));
  CHECK(read_bytes("a.txt", counted(0, 12)).points[2] == Point{1, 7, 8});
  CHECK(read_bytes("a.txt", counted(1, 9)).points[2] == Point{3, 1, 7});  // too few to tell
  CHECK(read_bytes("a.txt", counted(1, 5) + counted(1, 10)).points[2] == Point{3, 1, 7});
}

TEST_CASE("guessed columns are told, and three columns need no guess") {
  CHECK(read_bytes("a.xyz", "1 2 3\n").warnings.empty());
  const Cloud cloud = read_bytes("a.xyz", "1 2 3 40\n");
  REQUIRE(cloud.warnings.size() == 1);
  CHECK(contains(cloud.warnings[0], "were taken for x y z intensity; name them in a first line"));
  CHECK(read_bytes("a.xyz", "x y z i\n1 2 3 40\n").warnings.empty());
}

TEST_CASE("a PTS may hold several scans, each with its number of points") {
  CHECK(read_bytes("a.pts", "2\n1.5 -2 3e-3\n4 5 6\n1\n7 8 9\n").points.size() == 3);
  CHECK(contains(complaint("a.pts", "2\n1.5 -2 3e-3\n4 5 6\n3\n7 8 9\n"),
                 "line 4: announces 3 points, but 1 follow"));
  CHECK(contains(complaint("a.pts", "1\n1.5 -2 3e-3\n4 5 6\n3\n7 8 9\n"),
                 "line 1: announces 1 points, but 2 follow"));
}

TEST_CASE("many columns of one name are read in time that grows as they do") {
  std::string header = "x,y,z", row = "1,2,3";
  for (int i = 0; i < 200000; ++i) header += ",a", row += ",5";
  const Cloud cloud =
      read_bytes("a.csv", header + "\n" + row + "\n");  // an hour where each looks through all
  REQUIRE(cloud.columns.size() == 200000);
  CHECK(cloud.columns[199999].name == "a_200000");
}

TEST_CASE("bad lines of text are named with the remedy") {
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5\n"),
                 "a.xyz, line 2: has 2 values where the lines before have 3"));
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5 6 7\n"), "line 2: has 4 values"));
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5 six\n"), "line 2: 'six' is not a number"));
  CHECK(contains(complaint("a.xyz", "1 2 3\n4 5 6x\n"), "line 2: '6x' is not a number"));
  CHECK(contains(complaint("a.csv", "1,2,3\n4,,6\n"), "line 2: value 2 is empty"));
  CHECK(contains(complaint("a.xyz", "1.5 2 3\n1,5 2,5 3\n"), "line 2: numbers with decimal commas"));
  CHECK(contains(complaint("a.xyz", "1 2\n"), "line 1: has 2 values; a point needs at least x, y and z"));
  CHECK(contains(complaint("a.xyz", "left right top\n1 2 3\n"), "line 1: 'left right top' is neither"));
  CHECK(contains(complaint("a.xyz", "x y z i\n1 2 3\n"),
                 "line 2: has 3 values where the header names 4 columns"));
  CHECK(contains(complaint("a.xyz", "3\n1 2 3\n4 5 6\n"), "announces 3 points, but 2 follow"));
  CHECK(contains(complaint("a.xyz", "# nothing\n\n"), "no line of numbers"));
}

}  // namespace
}  // namespace rimline
