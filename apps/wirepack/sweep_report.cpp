#include "sweep_report.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "wirepack/io/sweep_page.hpp"

#include "sweep_cost.hpp"

namespace wirepack {

std::string status_text(const std::filesystem::path& folder, const Survey& tasks) {
  const std::vector<double> left = seconds_left(tasks.status);
  std::size_t width = 5;
  for (const ListedTask& task : tasks.list.tasks) width = std::max(width, task.name.size());
  std::string text = fmt::format("#{:<{}} {:<14} {:>9} {:>10} {:>10} {:>10}  {}\n", "task", width,
                                 "state", "phi", "increment", "hours", "left", "remark");
  double spent = 0, rest = 0;
  for (std::size_t k = 0; k < tasks.status.size(); ++k) {
    const TaskStatus& task = tasks.status[k];
    text += fmt::format(" {:<{}} {:<14} {:>9.4f} {:>10.0f} {:>10} {:>10}  {}\n",
                        tasks.list.tasks[k].name, width, name_of(task.state),
                        task.last.packing_density, task.last.increment,
                        shown_hours(task.last.wall_seconds), shown_hours(left[k]), remark(task));
    spent += task.last.wall_seconds;
    rest = rest < 0 || left[k] < 0 ? -1 : rest + left[k];
  }
  text += fmt::format("# {}\n# hours of one processor: {} spent, about {} left\n", counts(tasks),
                      shown_hours(spent), shown_hours(rest));
  for (const std::string& name : tasks_beyond(tasks.list, folder)) {
    text += fmt::format("# {} is of an earlier plan\n", name);
  }
  return text;
}

std::filesystem::path write_status_page(const std::filesystem::path& folder, const Survey& tasks) {
  const std::vector<double> left = seconds_left(tasks.status);
  std::vector<SweepPageTask> lines;
  for (std::size_t k = 0; k < tasks.status.size(); ++k) {
    lines.push_back({tasks.list.tasks[k].name, tasks.status[k], left[k]});
  }
  return write_sweep_page(folder, counts(tasks), lines);
}

}  // namespace wirepack
