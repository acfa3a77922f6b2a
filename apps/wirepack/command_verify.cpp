#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/verify/known_problem.hpp"

#include "command.hpp"

namespace wirepack {

namespace {

int verify() {
  fmt::print("{:<58} {:>13} {:>13} {:>9} {:>9}\n", "problem", "exact", "measured", "error",
             "tolerance");
  int count = 0, failed = 0;
  for (const KnownProblemGroup& group : known_problem_groups()) {
    try {
      for (const KnownProblem& problem : group.run()) {
        ++count;
        failed += problem.passed() ? 0 : 1;
        fmt::print("{:<58} {:>13.8g} {:>13.8g} {:>9.2g} {:>9.2g}  {}\n", problem.name,
                   problem.exact, problem.measured, problem.error(), problem.tolerance,
                   problem.passed() ? "pass" : fmt::format("FAIL (tolerance: {})", problem.why));
      }
    } catch (const NumericalFailure& failure) {
      ++count;
      ++failed;
      fmt::print("{:<58} {}  FAIL\n", group.name, failure.what());
    }
    std::fflush(stdout);
  }
  fmt::print("# {} of {} passed\n", count - failed, count);
  return failed == 0 ? exit_done : exit_no_equilibrium;
}

}  // namespace

Command verify_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "verify", "Run the built-in problems with known answers: measured against exact.");
  app->footer(
      "Errors are relative to the exact answer, absolute where that is 0. Exit code 0 if all\n"
      "problems pass, 3 if one fails.\n"
      "Example: wirepack verify");
  return {app, verify};
}

}  // namespace wirepack
