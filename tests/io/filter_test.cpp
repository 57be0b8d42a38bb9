// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files.h"

namespace rimline {
namespace {

Cloud five() {
  Cloud cloud;
  for (int i = 0; i < 5; ++i) cloud.points.push_back({1.0 * i, 0, 0});
  cloud.columns = {make_column("Classification", std::vector<std::uint8_t>{2, 5, 2, 8, 2}),
                   make_column("ReturnNumber", std::vector<std::uint8_t>{1, 1, 2, 1, 2}),
                   make_column("number_of_returns", std::vector<std::uint8_t>{1, 2, 2, 1, 3})};
  return cloud;
}

std::vector<double> kept(const PointFilter& filter) {
  Cloud cloud = five();
  filter_points(cloud, filter, "a.las");
  std::vector<double> ids;
  for (const Point& p : cloud.points) ids.push_back(p.x);
  if (ids.size() < 5) {
    CHECK(values(cloud, "file_index") == ids);
    CHECK(cloud.warnings.size() == 1);
  }
  return ids;
}

TEST_CASE("points are chosen by class and return") {
  CHECK(kept({}) == std::vector<double>{0, 1, 2, 3, 4});
  CHECK(kept({.classes = {2}}) == std::vector<double>{0, 2, 4});
  CHECK(kept({.classes = {5, 8}}) == std::vector<double>{1, 3});
  CHECK(kept({.returns = Returns::First}) == std::vector<double>{0, 1, 3});
  CHECK(kept({.returns = Returns::Last}) == std::vector<double>{0, 2, 3});
  CHECK(kept({.returns = Returns::Only}) == std::vector<double>{0, 3});
  CHECK(kept({.classes = {2}, .returns = Returns::Last}) == std::vector<double>{0, 2});
}

TEST_CASE("a choice that leaves nothing, or that the file can not make, is refused") {
  const auto refusal = [](const Cloud& from, const PointFilter& filter) -> std::string {
    Cloud cloud = from;
    try {
      filter_points(cloud, filter, "a.las");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::CannotRead);
      return error.what();
    }
    return "was taken";
  };
  CHECK(
      contains(refusal(five(), {.classes = {6}}), "a.las: has no point of class 6; its classes are 2, 5, 8"));
  CHECK(contains(refusal(five(), {.classes = {5}, .returns = Returns::Last}), "no point is of that class"));
  Cloud bare;
  bare.points = {{0, 0, 0}};
  CHECK(contains(refusal(bare, {.classes = {2}}), "has no classification"));
  CHECK(contains(refusal(bare, {.returns = Returns::First}), "has no return_number"));
}

}  // namespace
}  // namespace rimline
