#include "wirepack/io/sweep_folder.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <system_error>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/continuation.hpp"
#include "wirepack/io/output_path.hpp"

#include "atomic_file.hpp"
#include "text_file.hpp"

namespace wirepack {

namespace {

constexpr std::size_t largest_list = 100'000'000;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream text(line);
  for (std::string word; std::getline(text, word, '\t');) words.push_back(word);
  if (!line.empty() && line.back() == '\t') words.emplace_back();
  return words;
}

std::string list_text(const Sweep& sweep) {
  const auto line = [](const std::string& name, const std::vector<std::string>& values) {
    std::string text = name;
    for (const std::string& value : values) text.append("\t").append(plain_text(value, 1000));
    return text.append("\n");
  };
  std::string text = line("task", sweep.keys);
  for (const SweepTask& task : sweep.tasks) text += line(task.name, task.values);
  return text;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  replace_file(file, {text.begin(), text.end()});
}

std::string config_text(const SweepTask& task) {
  return resolved_config(task.scenario, task.units);
}

enum class Difference { none, is_new, limits };

Difference difference(const std::filesystem::path& config, const SweepTask& task,
                      std::vector<std::string>& problems) {
  if (!std::filesystem::exists(config)) return Difference::is_new;
  const Configuration before = read_configuration(config);
  if (const auto conflict = continuation_conflict(before.scenario, task.scenario)) {
    problems.push_back(
        fmt::format("{}: is of another plan: {}; give another folder, or move this "
                    "task away",
                    config.parent_path().string(), *conflict));
  }
  return resolved_config(before.scenario, before.units) == config_text(task) ? Difference::none
                                                                             : Difference::limits;
}

}  // namespace

SweepChange write_sweep(const std::filesystem::path& folder, const Sweep& sweep) {
  output_folder(folder, {}, {});
  // A file of that name which is none of ours is not written over.
  if (std::filesystem::exists(folder / task_list_file)) read_task_list(folder);
  SweepChange change;
  std::vector<std::string> problems;
  std::vector<const SweepTask*> to_write;
  for (const SweepTask& task : sweep.tasks) {
    const Difference found = difference(folder / task.name / task_config_file, task, problems);
    if (found == Difference::none) continue;
    (found == Difference::is_new ? change.added : change.changed).push_back(task.name);
    to_write.push_back(&task);
  }
  if (!problems.empty()) throw InvalidInput(fmt::format("{}", fmt::join(problems, "\n")));
  for (const SweepTask* task : to_write) {
    make_folder(folder / task->name);
    write_text(folder / task->name / task_config_file, config_text(*task));
  }
  const std::filesystem::path list = folder / task_list_file;
  const std::string text = list_text(sweep);
  if (!std::filesystem::exists(list) || read_text(list, "a list", largest_list) != text) {
    write_text(list, text);
  }
  return change;
}

TaskList read_task_list(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / task_list_file;
  if (!std::filesystem::exists(file)) {
    throw InvalidInput(folder.string() + ": is not the folder of a sweep: there is no " +
                       task_list_file);
  }
  std::istringstream text(read_text(file, "a list of tasks", largest_list));
  TaskList list;
  std::string line;
  std::getline(text, line);
  list.keys = split(line);
  if (list.keys.empty() || list.keys.front() != "task") {
    throw InvalidInput(file.string() + ": is not a list of tasks");
  }
  list.keys.erase(list.keys.begin());
  for (std::size_t number = 2; std::getline(text, line); ++number) {
    std::vector<std::string> words = split(line);
    const bool safe = !words.empty() && !words.front().empty() && words.front().front() != '.' &&
                      words.front().find('/') == std::string::npos;
    if (!safe || words.size() != list.keys.size() + 1) {
      throw InvalidInput(fmt::format("{}:{}: is not a task", file.string(), number));
    }
    const std::string name = words.front();
    words.erase(words.begin());
    list.tasks.push_back({name, std::move(words)});
  }
  return list;
}

std::vector<std::string> tasks_beyond(const TaskList& list, const std::filesystem::path& folder) {
  std::set<std::string> known;
  for (const ListedTask& task : list.tasks) known.insert(task.name);
  std::vector<std::string> beyond;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (known.count(name) == 0 && std::filesystem::exists(entry.path() / task_config_file)) {
      beyond.push_back(name);
    }
  }
  std::sort(beyond.begin(), beyond.end());
  return beyond;
}

std::vector<std::string> results_named(const std::vector<std::string>& names) {
  std::vector<std::string> results;
  for (const std::string& name : names) {
    if (!std::filesystem::is_directory(name)) {
      results.push_back(name);
      continue;
    }
    const std::size_t before = results.size();
    for (const ListedTask& task : read_task_list(name).tasks) {
      const std::filesystem::path result =
          std::filesystem::path(name) / task.name / task_result_file;
      if (std::filesystem::exists(result)) results.push_back(result.string());
    }
    if (results.size() == before) throw FileError(name + ": no task has a result yet");
  }
  return results;
}

}  // namespace wirepack
