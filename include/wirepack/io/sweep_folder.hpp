#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wirepack/io/sweep_plan.hpp"

namespace wirepack {

/// The folder of a sweep: tasks.tsv, and a folder for each task with its configuration and result.
inline constexpr const char* task_list_file = "tasks.tsv";
inline constexpr const char* task_config_file = "config.toml";
inline constexpr const char* task_result_file = "run.h5";
inline constexpr const char* task_log_file = "run.log";

/// One line of tasks.tsv: the name is that of the task's folder.
struct ListedTask {
  std::string name;
  std::vector<std::string> values;  ///< of TaskList::keys
};

/// What belongs to a sweep.
struct TaskList {
  std::vector<std::string> keys;
  std::vector<ListedTask> tasks;
};

/// What a plan has changed in a folder.
struct SweepChange {
  std::vector<std::string> added;
  std::vector<std::string> changed;  ///< tasks whose limits or output are others than before
};

/// Brings the folder in line with a sweep, whose order of tasks is kept in the list. Removes
/// nothing. Throws InvalidInput, before anything is written, when a folder holds another
/// configuration under the name of a task, or a list that is none; FileError.
SweepChange write_sweep(const std::filesystem::path& folder, const Sweep& sweep);

/// Throws InvalidInput when the folder is not one of a sweep.
TaskList read_task_list(const std::filesystem::path& folder);

/// Folders of tasks that are not in the list: those of an earlier plan.
std::vector<std::string> tasks_beyond(const TaskList& list, const std::filesystem::path& folder);

/// The results that a name on the command line stands for: those of a sweep's folder, or itself.
std::vector<std::string> results_named(const std::vector<std::string>& names);

}  // namespace wirepack
