// SPDX-License-Identifier: GPL-3.0-or-later
// One call of the library from Python: the interpreter's lock is released, Ctrl-C and `progress` are heard.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <exception>

#include "rimline/run.h"

namespace rimline::python {

namespace nb = nanobind;

// rimline::Run as Python gives it.
struct RunArguments {
  std::uint64_t seed = 1;
  int threads = 0;
  std::size_t memory_limit = 0;
  nb::object progress;  // None or a callable (stage, done, total); False from it cancels
};

// Listens while the library works. What Python raises meanwhile is kept, and the library is told to stop.
class Listener {
 public:
  explicit Listener(const RunArguments& arguments);
  const Run& run() const { return run_; }
  // Raises what made the library stop, if anything did.
  void rethrow() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  void hear(Progress progress);
  void ask(Progress progress);

  nb::object progress_;
  std::atomic<bool> stop_{false};
  std::exception_ptr raised_;
  Stage stage_ = Stage::Read;
  bool asked_ = false;
  std::chrono::steady_clock::time_point last_;
  Run run_;
};

// work(run) without the interpreter's lock. Throws what `progress` or a signal handler raised.
template <class Work>
auto call(const RunArguments& arguments, const Work& work) {
  Listener listener(arguments);
  try {
    auto result = [&] {
      const nb::gil_scoped_release released;
      return work(listener.run());
    }();
    listener.rethrow();  // raised too late for the library to hear of it
    return result;
  } catch (const Error&) {
    listener.rethrow();
    throw;
  }
}

}  // namespace rimline::python
