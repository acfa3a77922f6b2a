#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wirepack {

/// Programs that run the tasks of a sweep.
enum class SweepEngine { slurm, parallel, snakemake, hyperqueue };

struct SweepScriptOptions {
  std::string program;     ///< path of wirepack on the machines that run it
  int threads = 1;         ///< of each task
  int at_once = 0;         ///< tasks, of Slurm and GNU parallel; 0: as many as these like
  int tasks_per_job = 1;   ///< of Slurm, one after the other
  int most_restarts = 50;  ///< of a job of Slurm that reaches its time limit
  std::string hosts;       ///< file with the hosts of GNU parallel; empty: this one alone
};

/// Writes what the engine needs to run these tasks into the folder of a sweep (see
/// sweep_folder.hpp): slurm.sh, parallel.sh, Snakefile or hyperqueue.sh. Throws FileError.
std::filesystem::path write_sweep_script(const std::filesystem::path& folder, SweepEngine engine,
                                         const std::vector<std::string>& tasks,
                                         const SweepScriptOptions& options);

}  // namespace wirepack
