#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "wirepack/io/recorded_run.hpp"

namespace wirepack {

/// What a run shows while it runs: the table, if one is wanted, and its progress on a terminal.
class RunDisplay {
 public:
  /// `table` may be null.
  RunDisplay(const Scenario& scenario, std::FILE* table);
  ~RunDisplay();
  RunDisplay(const RunDisplay&) = delete;
  RunDisplay& operator=(const RunDisplay&) = delete;

  /// Hooks that show and that listen to signals; they refer to this display.
  RunHooks hooks();
  /// The reader of the table has gone away, which ends the run.
  bool unread() const;

 private:
  struct Shown;
  std::unique_ptr<Shown> shown_;
};

/// A duration for people: "45 s", "12 min".
std::string shown_time(double seconds);

}  // namespace wirepack
