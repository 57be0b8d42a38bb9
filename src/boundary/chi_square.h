// SPDX-License-Identifier: GPL-3.0-or-later
// The limiting distribution of eq. (1).
#pragma once

namespace rimline {

// -log Pr(X >= statistic) for X chi-square distributed with `degrees` >= 1 degrees of freedom. Natural
// logarithm; finite for every finite statistic >= 0, also where the probability is below the least double.
double negative_log_survival(double statistic, int degrees);

}  // namespace rimline
