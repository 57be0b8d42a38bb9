// SPDX-License-Identifier: GPL-3.0-or-later
#include "boundary/chi_square.h"

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

namespace rimline {
namespace {

// The upper incomplete gamma function is x^a exp(-x) / F(a, x), with the continued fraction
// F = x + 1 - a - 1 (1 - a) / (x + 3 - a - 2 (2 - a) / (x + 5 - a - ...)), Abramowitz & Stegun 6.5.31,
// evaluated from the front (Lentz 1976). It converges fast where x is well above a.
double continued_fraction(double a, double x) {
  double b = x + 1 - a;
  double value = b, c = b, d = 0;
  for (int i = 1; i < 1000; ++i) {
    const double term = i * (a - i);
    b += 2;
    d = 1 / (b + term * d);
    c = b + term / c;
    value *= c * d;
    if (std::abs(c * d - 1) < 1e-15) break;
  }
  return value;
}

}  // namespace

double negative_log_survival(double statistic, int degrees) {
  const double a = 0.5 * degrees, x = 0.5 * statistic;
  if (x <= 0) return 0;
  if (x < a + 100) return -std::log(boost::math::gamma_q(a, x));
  return x - a * std::log(x) + std::lgamma(a) + std::log(continued_fraction(a, x));
}

}  // namespace rimline
