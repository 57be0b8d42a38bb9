// SPDX-License-Identifier: GPL-3.0-or-later
// What a stranger writes first: a cloud in, a mesh out, and one error caught.
#include <rimline/cloud.h>
#include <rimline/io.h>
#include <rimline/pipeline.h>
#include <rimline/sample.h>
#include <rimline/version.h>

#include <cstdio>
#include <vector>

int main() {
  const rimline::Run run;
  const rimline::Sample cap = rimline::sample({.shape = rimline::Shape::HemisphereCap, .n = 800}, run);
  const auto options = rimline::preset_options(rimline::Preset::Default);
  const rimline::ReconstructResult result = rimline::reconstruct(cap.points, options, run);
  std::printf("rimline %s: %zu triangles\n", rimline::version, result.triangles.size());
  if (result.triangles.size() < cap.points.size()) return 1;
  try {
    rimline::reconstruct(std::vector<rimline::Point>(1), options, run);
  } catch (const rimline::Error& error) {
    return error.code() == rimline::ErrorCode::TooFewPoints ? 0 : 2;
  }
  return 3;
}
