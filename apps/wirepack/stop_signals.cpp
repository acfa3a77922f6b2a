#include "stop_signals.hpp"

#include <csignal>
#include <initializer_list>

namespace wirepack {

namespace {

// A signal handler has no other way to tell.
volatile sig_atomic_t stop_requested = 0;
volatile sig_atomic_t save_requested = 0;

extern "C" void note_stop_signal(int number) {
  // Schedulers repeat their signals; only a person who presses Ctrl-C twice means it.
  if (number == SIGINT && stop_requested != 0) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
  stop_requested = 1;
}

extern "C" void note_save_signal(int) { save_requested = 1; }

void catch_signal(int number, void (*handler)(int)) {
  struct sigaction before {};
  sigaction(number, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(number, &action, nullptr);
}

}  // namespace

void catch_stop_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    catch_signal(number, note_stop_signal);
  }
  catch_signal(SIGUSR1, note_save_signal);
  // Whoever starts a run may have held these back until now (see ProcessKind::run).
  sigset_t caught;
  sigemptyset(&caught);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&caught, number);
  sigprocmask(SIG_UNBLOCK, &caught, nullptr);
}

bool stop_was_requested() { return stop_requested != 0; }

bool save_was_requested() {
  const bool requested = save_requested != 0;
  if (requested) save_requested = 0;
  return requested;
}

}  // namespace wirepack
