#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "wirepack/io/sweep_folder.hpp"
#include "wirepack/io/sweep_status.hpp"

namespace wirepack {

/// All tasks of a folder, in the order of its list.
struct Survey {
  TaskList list;
  std::vector<TaskStatus> status;

  std::size_t count(TaskState state) const;
};

/// Throws InvalidInput when the folder is not one of a sweep.
Survey survey(const std::filesystem::path& folder);

/// "5 tasks: 3 done, 2 waiting".
std::string counts(const Survey& tasks);

/// Why a task has ended, or who runs it.
std::string remark(const TaskStatus& task);

/// The exit code of a sweep: the worst of its tasks.
int exit_code_of(const Survey& tasks);

}  // namespace wirepack
