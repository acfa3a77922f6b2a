#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

enum class TaskState {
  done,            ///< a limit is reached
  no_equilibrium,  ///< finished, too: there was no way on
  running,         ///< a process holds its lock
  resumable,       ///< was stopped or killed, with increments saved
  waiting,         ///< nothing is saved
  failed,          ///< the last attempt ended with an error
};
std::string_view name_of(TaskState state);
inline constexpr TaskState all_task_states[] = {TaskState::done,    TaskState::no_equilibrium,
                                                TaskState::running, TaskState::resumable,
                                                TaskState::waiting, TaskState::failed};

/// Neither finished nor at work.
bool can_go_on(TaskState state);

struct TaskStatus {
  TaskState state = TaskState::waiting;
  Scenario scenario;        ///< of its configuration; the default one if that is damaged
  HistoryRow last;          ///< of the result; zeros without one
  std::string stop_reason;  ///< of a finished one
  int exit_code = 0;        ///< of a failure
  std::string remark;       ///< a failure's last message; the process that runs it
};

/// What the files of a task say. Changes nothing, and is in no run's way.
TaskStatus task_status(const std::filesystem::path& task_folder);

/// `wirepack run --log` ends what it adds with this and the exit code; task_status() looks for it.
inline constexpr std::string_view exit_code_line = "exit code ";

}  // namespace wirepack
