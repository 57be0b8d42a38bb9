// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and cancel: both are part of the value `Run` that is passed along.
#include <rimline/pipeline.h>
#include <rimline/sample.h>

#include <atomic>
#include <cstdio>

using namespace rimline;

int main() {
  const Sample saddle = sample({.shape = Shape::WavySaddle, .n = 20000}, {});
  const Options options = preset_options(Preset::Default);

  // Called from this thread, at least ten times a second. Here it also asks the run to stop in a certain
  // stage; a signal handler or another thread may do the same.
  std::atomic<bool> stop = false;
  Run run;
  run.stop = &stop;
  run.on_progress = [&stop](Progress progress) {
    std::printf("%-12s %zu of %zu\n", name(progress.stage), progress.done, progress.total);
    if (progress.stage == Stage::Refine) stop = true;
  };
  try {
    reconstruct(saddle.points, options, run);
  } catch (const Error& error) {
    std::printf("%s\n", error.what());
    return error.code() == ErrorCode::Cancelled ? 0 : 1;
  }
  return 1;
}
