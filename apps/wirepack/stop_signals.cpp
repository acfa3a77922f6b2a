#include "stop_signals.hpp"

#include <csignal>

namespace wirepack {

namespace {

// A signal handler has no other way to tell.
volatile sig_atomic_t requested = 0;

extern "C" void note_stop_signal(int) { requested = 1; }

}  // namespace

void catch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = note_stop_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
}

bool stop_was_requested() { return requested != 0; }

}  // namespace wirepack
