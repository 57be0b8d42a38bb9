// SPDX-License-Identifier: GPL-3.0-or-later
#include "call.h"

#include <system_error>

namespace rimline::python {
namespace {

// Between two looks at Python: it takes the lock, which other threads may hold.
constexpr auto period = std::chrono::milliseconds(20);

}  // namespace

Listener::Listener(const RunArguments& arguments)
    : progress_(arguments.progress), is_heard_(!arguments.progress.is_none()) {
  run_.seed = arguments.seed;
  run_.threads = arguments.threads;
  run_.memory_limit = arguments.memory_limit;
  run_.stop = &stop_;
  run_.on_progress = [this](Progress progress) { tell(progress); };
}

void Listener::listen(const std::function<void()>& work) {
  const auto work_and_tell = [&] {
    try {
      work();
    } catch (...) {
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    is_done_ = true;
    changed_.notify_all();
  };
  {
    const nb::gil_scoped_release released;
    try {
      std::thread worker(work_and_tell);
      wait_for_worker();
      worker.join();
    } catch (const std::system_error&) {  // no thread is to be had: signals are heard with progress alone
      work_and_tell();
    }
  }
  if (raised_) std::rethrow_exception(raised_);
  if (failure_) std::rethrow_exception(failure_);
  run_.check_cancel();  // said too late for the library to hear of it
}

void Listener::wait_for_worker() {
  std::unique_lock lock(mutex_);
  while (!is_done_) {
    changed_.wait_for(lock, period, [&] { return is_done_ || told_; });
    if (is_done_) return;
    const std::optional<Progress> told = told_;
    lock.unlock();
    ask(told);
    lock.lock();
    if (!told) continue;
    told_.reset();
    changed_.notify_all();
  }
}

// On the thread that works, which goes on when Python has heard.
void Listener::tell(Progress progress) {
  const auto now = std::chrono::steady_clock::now();
  const bool is_alone = std::this_thread::get_id() == caller_;
  if (!(is_heard_ || is_alone) || stop_ || (stage_ == progress.stage && now - last_ < period)) return;
  stage_ = progress.stage;
  last_ = now;
  if (is_alone) return ask(progress);
  std::unique_lock lock(mutex_);
  told_ = progress;
  changed_.notify_all();
  changed_.wait(lock, [&] { return !told_; });
}

void Listener::ask(std::optional<Progress> progress) {
  if (stop_) return;
  const nb::gil_scoped_acquire held;
  try {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    if (!progress || !is_heard_) return;
    const nb::object answer = progress_(name(progress->stage), progress->done, progress->total);
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
