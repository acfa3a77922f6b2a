#include "wirepack/io/sweep_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <string>

#include "wirepack/core/error.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/sweep_folder.hpp"
#include "wirepack/io/sweep_status.hpp"
#include "wirepack/observe/sample.hpp"

#include "atomic_file.hpp"

namespace wirepack {

namespace {

constexpr std::string_view seed_key = "packing.seed";

/// A quantity that is averaged over seeds, in the units of the wire and the cavity.
struct Averaged {
  std::string_view name;
  double (*of)(const HistoryRow&, const Scenario&);
};

constexpr std::array<Averaged, 4> averaged{{
    {"packing_density", [](const HistoryRow& r, const Scenario&) { return r.packing_density; }},
    {"scaled_force", [](const HistoryRow& r, const Scenario&) { return r.scaled_force; }},
    {"bend_energy", [](const HistoryRow& r,
                       const Scenario& s) { return r.energy_bend / units_of(s).scaled_energy(); }},
    {"twist_energy",
     [](const HistoryRow& r, const Scenario& s) {
       return r.energy_twist / units_of(s).scaled_energy();
     }},
}};
using Values = std::array<std::vector<double>, averaged.size()>;

/// Finished runs that differ in their seed alone.
struct Group {
  std::vector<std::string> values;  // of all keys but the seed
  Values ends;
  std::map<std::int64_t, Values> curves;  // by the number of the density's interval
  double spacing = 0;                     // of densities
};

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string cells(const std::vector<std::string>& texts) {
  std::string line;
  for (const std::string& text : texts) line += cell(text) + ",";
  return line;
}

// Mean, deviation of one run (empty for a single one), smallest, largest.
std::string statistics(const std::vector<double>& values) {
  const Sample s = sample(values);
  const std::string deviation = s.count > 1 ? fmt::format("{:.8g}", s.deviation) : "";
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{:.8g},{},{:.8g},{:.8g}", s.mean, deviation, *least, *most);
}

std::string statistics_header(std::string_view name) {
  return fmt::format("{0}_mean,{0}_deviation,{0}_smallest,{0}_largest", name);
}

/// The tables while they grow.
class Tables {
 public:
  explicit Tables(TaskList list) : list_(std::move(list)) {
    runs_ = fmt::format("task,{}", cells(list_.keys)) +
            "state,stop_reason,increment,inserted_length,packing_density,scaled_force,bend_energy,"
            "twist_energy,wall_seconds\n";
  }

  void add(const ListedTask& task, const std::filesystem::path& folder) {
    const TaskStatus status = task_status(folder);
    const HistoryRow& last = status.last;
    runs_ += cell(task.name) + "," + cells(task.values) +
             fmt::format("{},{},{:.0f},{:.8g}", name_of(status.state), status.stop_reason,
                         last.increment, last.inserted_length);
    for (const Averaged& q : averaged) {
      runs_ += fmt::format(",{:.8g}", q.of(last, status.scenario));
    }
    runs_ += fmt::format(",{:.1f}\n", last.wall_seconds);
    if (status.state == TaskState::done || status.state == TaskState::no_equilibrium) {
      add_finished(task, status, folder / task_result_file);
    }
  }

  std::string runs() const { return runs_; }

  std::string seeds() const {
    std::string text = cells(group_keys()) + "runs";
    for (const Averaged& q : averaged) text.append(",").append(statistics_header(q.name));
    text += "\n";
    for (const Group& group : groups_) {
      text += cells(group.values) + std::to_string(group.ends[0].size());
      for (const std::vector<double>& values : group.ends)
        text.append(",").append(statistics(values));
      text += "\n";
    }
    return text;
  }

  std::string curves() const {
    std::string text = cells(group_keys()) + "packing_density,runs";
    for (std::size_t q = 1; q < averaged.size(); ++q) {
      text.append(",").append(statistics_header(averaged[q].name));
    }
    text += "\n";
    for (const Group& group : groups_) {
      for (const auto& [interval, sample] : group.curves) {
        text += cells(group.values) +
                fmt::format("{:.8g},{}", (static_cast<double>(interval) + 0.5) * group.spacing,
                            sample[1].size());
        for (std::size_t q = 1; q < averaged.size(); ++q)
          text.append(",").append(statistics(sample[q]));
        text += "\n";
      }
    }
    return text;
  }

 private:
  std::vector<std::string> group_keys() const { return without_seed(list_.keys); }

  std::vector<std::string> without_seed(const std::vector<std::string>& of_keys) const {
    std::vector<std::string> rest;
    for (std::size_t k = 0; k < of_keys.size(); ++k) {
      if (list_.keys[k] != seed_key) rest.push_back(of_keys[k]);
    }
    return rest;
  }

  Group& group_of(const ListedTask& task) {
    const std::vector<std::string> values = without_seed(task.values);
    for (Group& group : groups_) {
      if (group.values == values) return group;
    }
    groups_.push_back({values, {}, {}, 0});
    return groups_.back();
  }

  void add_finished(const ListedTask& task, const TaskStatus& status,
                    const std::filesystem::path& result) {
    Group& group = group_of(task);
    if (group.spacing == 0) group.spacing = status.scenario.output.frame_every_density;
    std::map<std::int64_t, Values> of_run;
    for (const HistoryRow& row : Hdf5Reader(result).history()) {
      const double interval = std::floor(row.packing_density / group.spacing);
      Values& values = of_run[static_cast<std::int64_t>(interval)];
      for (std::size_t q = 0; q < averaged.size(); ++q) {
        values[q].push_back(averaged[q].of(row, status.scenario));
      }
    }
    for (const auto& [interval, of_interval] : of_run) {
      for (std::size_t q = 0; q < averaged.size(); ++q) {
        group.curves[interval][q].push_back(sample(of_interval[q]).mean);
      }
    }
    for (std::size_t q = 0; q < averaged.size(); ++q) {
      group.ends[q].push_back(averaged[q].of(status.last, status.scenario));
    }
  }

  TaskList list_;
  std::string runs_;
  std::vector<Group> groups_;
};

}  // namespace

std::vector<std::filesystem::path> write_sweep_tables(const std::filesystem::path& folder) {
  const TaskList list = read_task_list(folder);
  Tables tables(list);
  for (const ListedTask& task : list.tasks) tables.add(task, folder / task.name);
  const std::filesystem::path target = folder / "tables";
  make_folder(target);
  std::vector<std::filesystem::path> files;
  const auto write = [&](const char* name, const std::string& text) {
    files.push_back(target / name);
    replace_file(files.back(), {text.begin(), text.end()});
  };
  write("runs.csv", tables.runs());
  write("seeds.csv", tables.seeds());
  write("curves.csv", tables.curves());
  return files;
}

}  // namespace wirepack
