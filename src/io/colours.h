// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of points, for any number type of a file.
#pragma once

#include <array>
#include <optional>

#include "rimline/cloud.h"

namespace rimline::io {

struct Colours {
  std::array<const Column*, 3> channels{};
  double white = 255;  // value of a full channel in the file

  // From 0 to 1; 0 where there is no number.
  double share(Index point, std::size_t channel) const;
  std::uint8_t byte(Index point, std::size_t channel) const;
};

// From the columns red, green and blue. Full is 255 for uchar; for ushort 65535, or 255 where none is larger,
// as some scanners write LAS; for other types 1, or 255 or 65535 as the largest asks for. Nothing without all
// three.
std::optional<Colours> colours_of(const Cloud& cloud);

}  // namespace rimline::io
