#include "sweep_survey.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "command.hpp"

namespace wirepack {

std::size_t Survey::count(TaskState state) const {
  return static_cast<std::size_t>(
      std::count_if(status.begin(), status.end(),
                    [state](const TaskStatus& task) { return task.state == state; }));
}

Survey survey(const std::filesystem::path& folder) {
  Survey result{read_task_list(folder), {}};
  for (const ListedTask& task : result.list.tasks) {
    result.status.push_back(task_status(folder / task.name));
  }
  return result;
}

std::string counts(const Survey& tasks) {
  std::string text;
  for (const TaskState state : all_task_states) {
    const std::size_t count = tasks.count(state);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(state));
  }
  return fmt::format("{} tasks: {}", tasks.status.size(), text);
}

std::string remark(const TaskStatus& task) {
  const std::string& reason = task.remark.empty() ? task.stop_reason : task.remark;
  if (task.state != TaskState::failed) return reason;
  // a full disk may have no room for a message either
  return fmt::format("exit code {}: {}", task.exit_code,
                     reason.empty() ? "its log says nothing" : reason);
}

int exit_code_of(const Survey& tasks) {
  int code = tasks.count(TaskState::no_equilibrium) > 0 ? exit_no_equilibrium : exit_done;
  const auto left = [&](TaskState state) { return tasks.count(state) > 0; };
  if (left(TaskState::running)) code = exit_file_error;
  if (left(TaskState::resumable) || left(TaskState::waiting)) code = exit_stopped_by_signal;
  for (const TaskStatus& task : tasks.status) {
    if (task.state == TaskState::failed) code = task.exit_code;
  }
  return code;
}

}  // namespace wirepack
