#include "wirepack/io/sweep_status.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/continuation.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/result_end.hpp"
#include "wirepack/io/result_lock.hpp"
#include "wirepack/io/sweep_folder.hpp"

namespace wirepack {

namespace {

constexpr int code_of_bad_input = 2, code_of_file_error = 5, code_of_a_stop = 75;
constexpr std::size_t longest_remark = 300;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::vector<std::string> last_lines(const std::filesystem::path& file) {
  constexpr std::streamoff enough = 4096;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  std::vector<std::string> lines;
  if (!in) return lines;
  in.seekg(std::max<std::streamoff>(0, std::streamoff(in.tellg()) - enough));
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// How the last attempt has ended, by the end of its log.
struct LastEnd {
  std::optional<int> exit_code;  // nothing: there was none, or it was killed
  std::string message;           // the line before
};

LastEnd last_end(const std::filesystem::path& log) {
  const std::vector<std::string> lines = last_lines(log);
  if (lines.empty()) return {std::nullopt, ""};
  const std::size_t at = lines.back().rfind(exit_code_line);
  if (at == std::string::npos) return {std::nullopt, "was killed"};
  const char* begin = lines.back().data() + at + exit_code_line.size();
  int code = 0;
  std::from_chars(begin, lines.back().data() + lines.back().size(), code);
  return {code, lines.size() > 1 ? plain_text(lines[lines.size() - 2], longest_remark) : ""};
}

void fail(TaskStatus& status, int code, const std::string& message) {
  status.state = TaskState::failed;
  status.exit_code = code;
  status.remark = plain_text(first_line(message), longest_remark);
}

// Fills in what the result holds; true if it is finished.
bool read_result(const std::filesystem::path& result, TaskStatus& status) {
  const Hdf5Reader reader(result);
  const std::vector<HistoryRow> history = reader.history();
  if (!history.empty()) status.last = history.back();
  std::optional<StopReason> end;
  if (reader.config() == resolved_config(status.scenario)) {
    end = stop_reason_of(reader);
  } else if (const auto conflict = continuation_conflict(reader.scenario(), status.scenario)) {
    throw InvalidInput("the result is of another configuration: " + *conflict);
  } else if (reader.finished()) {
    end = end_of(reader, status.scenario);
  }
  if (!end) return false;
  status.stop_reason = name_of(*end);
  status.state = found_no_equilibrium(*end) ? TaskState::no_equilibrium : TaskState::done;
  return true;
}

}  // namespace

std::string_view name_of(TaskState state) {
  switch (state) {
    case TaskState::done:
      return "done";
    case TaskState::no_equilibrium:
      return "no equilibrium";
    case TaskState::running:
      return "running";
    case TaskState::resumable:
      return "resumable";
    case TaskState::waiting:
      return "waiting";
    case TaskState::failed:
      return "failed";
  }
  return "";
}

bool can_go_on(TaskState state) {
  return state == TaskState::waiting || state == TaskState::resumable || state == TaskState::failed;
}

TaskStatus task_status(const std::filesystem::path& task_folder) {
  TaskStatus status;
  const std::filesystem::path result = task_folder / task_result_file;
  const std::optional<std::string> writer = writer_of(result);
  const bool there = std::filesystem::exists(result);
  try {
    status.scenario = read_config(task_folder / task_config_file);
    if (there && read_result(result, status)) return status;
  } catch (const InvalidInput& error) {
    fail(status, code_of_bad_input, error.what());
    return status;
  } catch (const FileError& error) {
    fail(status, code_of_file_error, error.what());
    return status;
  }
  if (writer) {
    status.state = TaskState::running;
    status.remark = *writer;
    return status;
  }
  const LastEnd end = last_end(task_folder / task_log_file);
  status.state = there ? TaskState::resumable : TaskState::waiting;
  status.remark = end.message;
  if (end.exit_code == code_of_a_stop) status.remark = "was stopped by a signal";
  // Zero: it was done, and its limits have been raised since.
  if (end.exit_code && *end.exit_code != 0 && *end.exit_code != code_of_a_stop) {
    fail(status, *end.exit_code, end.message);
  } else if (end.exit_code == 0) {
    status.remark.clear();
  }
  return status;
}

}  // namespace wirepack
