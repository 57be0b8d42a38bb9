// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/chi_square.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

namespace rimline {
namespace {

TEST_CASE("p-values are those of the published chi-square tables") {
  // Upper critical values (degrees, probability, statistic), as printed in any handbook of statistics.
  const double table[][3] = {{1, 0.05, 3.841},   {1, 0.01, 6.635},   {2, 0.10, 4.605},
                             {3, 0.05, 7.815},   {5, 0.01, 15.086},  {7, 0.10, 12.017},
                             {7, 0.05, 14.067},  {7, 0.01, 18.475},  {7, 0.001, 24.322},
                             {10, 0.05, 18.307}, {30, 0.05, 43.773}, {100, 0.05, 124.342}};
  for (const auto& [degrees, probability, statistic] : table) {
    CHECK(std::exp(-negative_log_survival(statistic, static_cast<int>(degrees))) ==
          doctest::Approx(probability).epsilon(2e-3));
  }
}

TEST_CASE("with two degrees of freedom the law is exponential, however far out") {
  for (const double x : {0.5, 10.0, 150.0, 250.0, 1470.0, 1e5, 1e9}) {
    CHECK(negative_log_survival(x, 2) == doctest::Approx(x / 2).epsilon(1e-12));
  }
}

TEST_CASE("with four degrees of freedom the law is (1 + x/2) exp(-x/2)") {
  for (const double x : {1.0, 30.0, 199.0, 203.0, 205.0, 1e4}) {
    CHECK(negative_log_survival(x, 4) == doctest::Approx(x / 2 - std::log1p(x / 2)).epsilon(1e-12));
  }
}

TEST_CASE("the logarithm grows smoothly where the far formula takes over") {
  for (const int degrees : {1, 7, 63, 359}) {
    const double takeover = degrees + 200;
    for (double x = takeover - 5; x < takeover + 5; x += 0.5) {
      const double before = negative_log_survival(x - 0.5, degrees);
      const double here = negative_log_survival(x, degrees);
      const double after = negative_log_survival(x + 0.5, degrees);
      CHECK(here > before);
      CHECK(std::abs(before - 2 * here + after) <
            1e-3);  // its second difference, where the slope is near 1/2
    }
  }
}

TEST_CASE("the logarithm is finite for any statistic and any number of sectors") {
  for (const int degrees : {1, 7, 63, 359}) {
    for (double x = 0; x < 1e12; x = 3 * x + 0.1) CHECK(std::isfinite(negative_log_survival(x, degrees)));
  }
}

}  // namespace
}  // namespace rimline
