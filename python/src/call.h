// SPDX-License-Identifier: GPL-3.0-or-later
// One call of the library from Python: the interpreter's lock is released, Ctrl-C and `progress` are heard.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

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

// Has the library work on another thread and listens on the one that called: Python's signals come to that
// one alone, and it hears them whatever the library is at. What Python raises meanwhile is kept, and the
// library is told to stop.
class Listener {
 public:
  explicit Listener(const RunArguments& arguments);
  const Run& run() const { return run_; }
  // Throws what `work` threw, or what `progress` or a signal handler raised; Error{Cancelled} if `progress`
  // said no.
  void listen(const std::function<void()>& work);

 private:
  void tell(Progress progress);
  void wait_for_worker();
  void ask(std::optional<Progress> progress);

  nb::object progress_;
  bool is_heard_;  // there is somebody to tell
  std::atomic<bool> stop_{false};
  std::exception_ptr raised_, failure_;
  Run run_;
  std::thread::id caller_ = std::this_thread::get_id();
  // Of the thread that works.
  std::optional<Stage> stage_;
  std::chrono::steady_clock::time_point last_;
  // Between the two threads.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Progress> told_;  // until Python has heard of it
  bool is_done_ = false;
};

// work(run) without the interpreter's lock.
template <class Work>
auto call(const RunArguments& arguments, const Work& work) {
  Listener listener(arguments);
  std::optional<decltype(work(listener.run()))> result;
  listener.listen([&] { result.emplace(work(listener.run())); });
  return std::move(*result);
}

}  // namespace rimline::python
