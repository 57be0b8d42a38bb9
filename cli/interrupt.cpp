// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.h"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>

#include "rimline/io.h"

namespace rimline::cli {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

namespace {

constexpr int status_interrupted = 5;

// Ends the process where no step has tested `interrupted` in time.
extern "C" void on_deadline(int) {
  remove_unfinished_files();
  const char text[] = "\nrimline: interrupted\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, sizeof text - 1);
  _exit(status_interrupted);
}

extern "C" void on_interrupt(int signal) {
  if (interrupted.exchange(true)) on_deadline(signal);
  const itimerval deadline = {{0, 0}, {0, 800'000}};
  setitimer(ITIMER_REAL, &deadline, nullptr);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  // No SA_RESTART: a read that waits for a pipe must return.
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void catch_interrupts() {
  handle(SIGINT, on_interrupt);
  handle(SIGTERM, on_interrupt);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, on_interrupt);  // nohup ignores it
  handle(SIGXCPU, on_interrupt);
  handle(SIGALRM, on_deadline);
  handle(SIGPIPE, SIG_IGN);
  handle(SIGXFSZ, SIG_IGN);
}

}  // namespace rimline::cli
