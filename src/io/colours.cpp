// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/colours.h"

#include <algorithm>
#include <cmath>

namespace rimline::io {

double Colours::share(Index point, std::size_t channel) const {
  const double share = channels[channel]->value(point) / white;
  return std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0);
}

std::uint8_t Colours::byte(Index point, std::size_t channel) const {
  return static_cast<std::uint8_t>(std::lround(255 * share(point, channel)));
}

std::optional<Colours> colours_of(const Cloud& cloud) {
  Colours colours{{cloud.find("red"), cloud.find("green"), cloud.find("blue")}};
  double largest = 0;
  bool bytes = true, integers = true;
  for (const Column* channel : colours.channels) {
    if (channel == nullptr) return std::nullopt;
    bytes = bytes && channel->type == Scalar::UInt8;
    integers = integers && channel->type != Scalar::Float32 && channel->type != Scalar::Float64;
  }
  if (bytes) return colours;
  for (const Column* channel : colours.channels) {
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      const double value = channel->value(static_cast<Index>(i));
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  }
  colours.white = largest > 255 ? 65535 : largest > 1 || integers ? 255 : 1;
  return colours;
}

}  // namespace rimline::io
