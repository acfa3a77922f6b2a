#include "process_pool.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <map>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace {

constexpr std::array stop_signals{SIGINT, SIGTERM, SIGHUP};

/// Holds back the signals that a pool waits for; those that ask to stop and are ignored stay so. A
/// caller that ignores SIGCHLD is not asked: what has ended could not be waited for then.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&held_);
    sigaddset(&held_, SIGCHLD);
    for (const int number : stop_signals) {
      struct sigaction action {};
      sigaction(number, nullptr, &action);
      if (action.sa_handler != SIG_IGN) sigaddset(&held_, number);
    }
    struct sigaction told {};
    told.sa_handler = SIG_DFL;
    sigaction(SIGCHLD, &told, &child_before_);
    pthread_sigmask(SIG_BLOCK, &held_, &before_);
  }
  ~HeldSignals() {
    sigaction(SIGCHLD, &child_before_, nullptr);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// The next signal, or zero after a second.
  int wait() const {
    const timespec second{1, 0};
    return std::max(0, sigtimedwait(&held_, nullptr, &second));
  }
  /// What a process of this kind starts with.
  sigset_t at_start(ProcessKind kind) const {
    sigset_t held = before_;
    for (const int number : stop_signals) {
      if (kind == ProcessKind::run && sigismember(&held_, number) > 0) sigaddset(&held, number);
    }
    return held;
  }

 private:
  sigset_t held_{}, before_{};
  struct sigaction child_before_ {};
};

pid_t start(const std::vector<std::string>& command, const sigset_t& signals) {
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_t files;
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setsigmask(&attributes, &signals);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t process = -1;
  const int error =
      posix_spawnp(&process, arguments[0], &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw FileError(command[0] + ": cannot be started: " + std::strerror(error));
  return process;
}

/// The processes at work, and the place of each command in the list.
using Running = std::map<pid_t, std::size_t>;

void send(int number, const Running& running) {
  for (const auto& [process, command] : running) ::kill(process, number);
}

void reap(Running& running, const PoolEvents& events) {
  for (auto at = running.begin(); at != running.end();) {
    int status = 0;
    if (::waitpid(at->first, &status, WNOHANG) != at->first) {
      ++at;
      continue;
    }
    const std::size_t command = at->second;
    at = running.erase(at);
    events.ended(command, WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status));
  }
}

// Runs save when they are asked to end.
void end_all(const Running& running) {
  send(SIGTERM, running);
  for (const auto& [process, command] : running) {
    while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

bool run_all(const std::vector<std::vector<std::string>>& commands, ProcessKind kind, int at_once,
             const PoolEvents& events, const HeldSignals& signals, Running& running) {
  std::size_t next = 0;
  bool stopped = false;
  while (!running.empty() || (next < commands.size() && !stopped)) {
    while (!stopped && next < commands.size() &&
           running.size() < static_cast<std::size_t>(at_once)) {
      running.emplace(start(commands[next], signals.at_start(kind)), next);
      ++next;
    }
    const int number = signals.wait();
    if (number != 0 && number != SIGCHLD) {
      stopped = true;
      send(number, running);
    }
    reap(running, events);
    events.each_second();
  }
  return !stopped;
}

}  // namespace

bool run_processes(const std::vector<std::vector<std::string>>& commands, ProcessKind kind,
                   int at_once, const PoolEvents& events) {
  const HeldSignals signals;
  Running running;
  try {
    return run_all(commands, kind, at_once, events, signals, running);
  } catch (...) {
    end_all(running);
    throw;
  }
}

}  // namespace wirepack
