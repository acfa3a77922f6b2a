#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>

namespace wirepack {

/// Exit codes of the program; the same for all commands.
enum ExitCode : int {
  exit_done = 0,
  exit_bad_input = 2,
  exit_no_equilibrium = 3,
  exit_numerical_failure = 4,
  exit_file_error = 5,
  exit_stopped_by_signal = 75,  ///< with everything saved; the code that schedulers requeue on
};

/// One command of the program: its options, and what it does when it was chosen. `run` returns an
/// exit code or throws InvalidInput, NumericalFailure or FileError.
struct Command {
  CLI::App* app;
  std::function<int()> run;
};

/// Runs a part of the program and gives its exit code; of an error, which is told on stderr behind
/// the name, the code that belongs to it.
int run_safely(const std::string& name, const std::function<int()>& run);

/// `command_line` is what the program was called with, for the provenance of results.
Command run_command(CLI::App& program, const std::string& command_line);
Command verify_command(CLI::App& program);
Command figures_command(CLI::App& program);
Command compare_command(CLI::App& program, const std::string& command_line);
Command analyze_command(CLI::App& program);
Command export_command(CLI::App& program);
Command fit_command(CLI::App& program, const std::string& command_line);
Command sweep_command(CLI::App& program);
Command view_command(CLI::App& program);

}  // namespace wirepack
