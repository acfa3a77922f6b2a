#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wirepack/io/sweep_script.hpp"

#include "sweep_survey.hpp"

namespace wirepack {

/// The path of this program: tasks are run by the same one. Throws FileError.
std::string this_program();

/// Runs the chosen tasks of a folder here, options.at_once at a time (0: what the processors
/// allow), and tells on stderr how far they are. False: a signal has stopped them.
bool run_here(const std::filesystem::path& folder, const Survey& tasks,
              const std::vector<std::size_t>& chosen, const SweepScriptOptions& options);

/// The script of an engine for the chosen tasks, in their folder. Throws FileError.
std::filesystem::path write_script(const std::filesystem::path& folder, const Survey& tasks,
                                   const std::vector<std::size_t>& chosen, SweepEngine engine,
                                   const SweepScriptOptions& options);

/// Hands a script to bash; its exit code, or nothing when a signal has stopped it. Throws FileError
/// when the engine could not be called, or Slurm has not taken all tasks.
std::optional<int> run_script(const std::filesystem::path& script, SweepEngine engine);

}  // namespace wirepack
