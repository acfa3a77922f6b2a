#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <malloc.h>
#include <new>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/core/shell_quoted.hpp"
#include "wirepack/core/threads.hpp"
#include "wirepack/core/version.hpp"

#include "command.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

std::string version_text() {
  const Version v = version();
  return fmt::format("wirepack {}\ncommit    {}\ncompiler  {}\nlibraries {}", v.program,
                     v.git_commit, v.compiler, v.libraries);
}

// The call as it can be given to a shell again.
std::string shell_text(int count, char** arguments) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += ' ';
    text += shell_quoted(arguments[i]);
  }
  return text;
}

constexpr const char* no_memory =
    "there is not enough memory; a lower [stop] limit or a longer wire.edge_length needs less";
constexpr const char* own_fault =
    "has failed by a fault of its own; please report the command and its configuration";

int report(const std::string& name, const std::exception& error, int code) {
  print_message(name + ": " + error.what());
  return code;
}

}  // namespace

int run_safely(const std::string& name, const std::function<int()>& run) {
  try {
    const int code = run();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw FileError("the standard output cannot be written");
    }
    return code;
  } catch (const InvalidInput& error) {
    return report(name, error, exit_bad_input);
  } catch (const NumericalFailure& error) {
    return report(name, error, exit_numerical_failure);
  } catch (const FileError& error) {
    return report(name, error, exit_file_error);
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string file = error.path1().string();
    return report(name, FileError(file + ": " + error.code().message()), exit_file_error);
  } catch (const std::system_error& error) {
    // words of the system, not of a library
    return report(name, FileError(error.code().message()), exit_file_error);
  } catch (const std::bad_alloc&) {
    return report(name, NumericalFailure(no_memory), exit_numerical_failure);
  } catch (const std::length_error&) {  // more than any memory has
    return report(name, NumericalFailure(no_memory), exit_numerical_failure);
  } catch (const std::exception&) {
    return report(name, NumericalFailure(own_fault), exit_numerical_failure);
  }
}

namespace {

// CLI11 calls a misspelt command a missing one.
std::string explain(const CLI::ParseError& error, const CLI::App& program, int count,
                    char** arguments) {
  const std::string first = count > 1 ? arguments[1] : "-";
  std::string names;
  for (const CLI::App* known : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (known->get_name() == first) return error.what();
    names += (names.empty() ? "" : ", ") + known->get_name();
  }
  if (first[0] == '-') return error.what();
  return fmt::format("there is no command '{}'; there is {}", first, names);
}

int run_program(int count, char** arguments) {
  use_threads(1);  // unless a command is told otherwise
  // A limit on the size of files shall give a message, as a full disk does, and not kill.
  std::signal(SIGXFSZ, SIG_IGN);
  // A reader that has gone away is an output that cannot be written: exit code 5.
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App program{"Packs a long elastic wire into a rigid cavity by energy minimization."};
  program.name("wirepack");
  program.set_version_flag("--version", version_text(), "Version, commit, compiler and libraries");
  program.set_help_flag("--help,-h", "This help");
  program.require_subcommand(1);
  program.footer(
      "Example: wirepack run data/scenarios/quickstart.toml -o quickstart.h5\n"
      "Exit codes: 0 done, 2 bad input, 3 no equilibrium found, 4 numerical failure,\n"
      "            5 file error, 75 stopped on a signal with everything saved");
  const std::vector<Command> commands{run_command(program, shell_text(count, arguments)),
                                      verify_command(program),
                                      figures_command(program),
                                      compare_command(program, shell_text(count, arguments)),
                                      analyze_command(program),
                                      export_command(program),
#ifdef WIREPACK_FIT
                                      fit_command(program, shell_text(count, arguments)),
#endif
                                      sweep_command(program),
                                      view_command(program)};
  try {
    program.parse(count, arguments);
  } catch (const CLI::Success& wish) {  // --help, --version
    program.exit(wish);
    return exit_done;
  } catch (const CLI::ParseError& error) {
    std::string name = "wirepack";
    for (const CLI::App* chosen : program.get_subcommands()) name += " " + chosen->get_name();
    const std::string text = explain(error, program, count, arguments);
    print_message(name + ": " + text + "; see " + name + " --help");
    return exit_bad_input;
  }
  for (const Command& command : commands) {
    if (command.app->parsed()) {
      return run_safely("wirepack " + command.app->get_name(), command.run);
    }
  }
  return exit_bad_input;
}

}  // namespace

}  // namespace wirepack

int main(int count, char** arguments) {
  // Factors of some megabytes come and go by the thousand: their memory is kept for the next one
  // (a sixth of the time of a factorization, else spent on fresh pages).
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  // The environment has precedence over what is told to HDF5. Results are replaced as a whole, so
  // there is nothing to lock, and one that another program has locked would look damaged.
  unsetenv("HDF5_USE_FILE_LOCKING");
  const int code = wirepack::run_program(count, arguments);
  // HDF5 cannot put away all of a damaged file and says so at length when a program ends; the
  // message of ours is enough.
  if (code == wirepack::exit_file_error) {
    std::fflush(nullptr);
    std::_Exit(code);
  }
  return code;
}
