// SPDX-License-Identifier: GPL-3.0-or-later
// What the table of reliability asks: point sets in files, random composite clouds, shapes that are no disc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quality/case.h"
#include "quality/validity.h"

namespace rimline::bench {

// One file, cloud or sample; the others' fields are empty.
struct Question {
  std::string group, name, path;
  std::uint64_t seed = 0, number = 0;  // of a hard cloud
  CaseName sample;
};

struct Asked {
  Case points;
  bool has_surface = true;        // where there is none, the right answer is a refusal
  std::optional<Topology> truth;  // where it is known
};

// The point sets below the folders (parted by ':'), truth meshes left out; a group a folder.
std::vector<Question> questions_of_files(const std::string& folders);
std::vector<Question> questions_of_clouds(std::uint64_t seed, std::size_t count);
// The closed sphere, the torus minus a cap and the Moebius strip, 5,000 points, `draws` times at noise 0, 0.2
// and 0.5 (standard deviation in mean distances of nearest neighbours).
std::vector<Question> questions_of_shapes(std::uint64_t seed, int draws);

// Reads or draws the points. Throws rimline::Error where a file is no point set.
Asked ask_for(const Question& question);

}  // namespace rimline::bench
