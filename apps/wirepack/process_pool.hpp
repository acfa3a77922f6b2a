#pragma once

#include <functional>
#include <string>
#include <vector>

namespace wirepack {

/// What a pool of processes tells of its work.
struct PoolEvents {
  /// A process has ended with this exit code, or by a signal, whose number is negative.
  std::function<void(std::size_t command, int code)> ended;
  std::function<void()> each_second;
};

/// What a pool of processes runs.
enum class ProcessKind {
  run,  ///< `wirepack run`: signals are held back from it until it can save (catch_stop_signals())
  other,  ///< signals reach it from the start
};

/// Runs commands (a program and its arguments) in their order, so many at once, until all have
/// ended. SIGINT, SIGTERM and SIGHUP are handed on to all that run, and no more are started then;
/// false: that has happened. Each is in a process group of its own, so that what is typed at a
/// terminal reaches it once. Throws FileError when a program cannot be started, after those that
/// run have been asked to end and have ended.
bool run_processes(const std::vector<std::vector<std::string>>& commands, ProcessKind kind,
                   int at_once, const PoolEvents& events);

}  // namespace wirepack
