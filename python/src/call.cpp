// SPDX-License-Identifier: GPL-3.0-or-later
#include "call.h"

namespace rimline::python {
namespace {

// Between two looks at Python: it takes the lock, which other threads may hold.
constexpr auto period = std::chrono::milliseconds(20);

}  // namespace

Listener::Listener(const RunArguments& arguments) : progress_(arguments.progress) {
  run_.seed = arguments.seed;
  run_.threads = arguments.threads;
  run_.memory_limit = arguments.memory_limit;
  run_.stop = &stop_;
  run_.on_progress = [this](Progress progress) { hear(progress); };
}

void Listener::hear(Progress progress) {
  const auto now = std::chrono::steady_clock::now();
  const bool is_new = !asked_ || progress.stage != stage_;
  if (stop_ || (!is_new && now - last_ < period)) return;
  asked_ = true;
  stage_ = progress.stage;
  last_ = now;
  ask(progress);
}

void Listener::ask(Progress progress) {
  const nb::gil_scoped_acquire held;
  try {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    if (progress_.is_none()) return;
    const nb::object answer = progress_(name(progress.stage), progress.done, progress.total);
    if (answer.is_none()) return;
    const int goes_on = PyObject_IsTrue(answer.ptr());
    if (goes_on < 0) throw nb::python_error();
    if (goes_on == 0) stop_ = true;
  } catch (...) {
    raised_ = std::current_exception();
    stop_ = true;
  }
}

}  // namespace rimline::python
