#include "wirepack/io/sweep_plan.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <sstream>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/config_file.hpp"

#include "problem_list.hpp"
#include "sweep_axes.hpp"
#include "text_file.hpp"
#include "toml_text.hpp"

namespace wirepack {

namespace {

constexpr std::size_t largest_file = 1'000'000;
constexpr std::size_t most_tasks = 100'000;
constexpr std::size_t longest_name = 200;  // a file system takes 255 bytes

/// A plan as it is written.
struct Plan {
  std::string base_text;
  std::string base_source;        // what messages call the text, and whose folder its files are in
  std::vector<SweepValue> fixed;  // keys of the plan itself
  std::vector<SweepAxis> axes;
};

Plan read_plan(std::string_view text, const std::filesystem::path& source) {
  const std::string name = source.string();
  std::vector<std::string> problems;
  Plan plan{"", name, {}, {}};
  toml::table root = toml_table(text, name);
  if (const toml::node* base = root.get("base")) {
    const auto* file = base->as_string();
    if (file == nullptr) throw InvalidInput(name + ": base must be the name of a configuration");
    const std::filesystem::path path = source.parent_path() / file->get();
    plan.base_text = read_text(path, "a configuration", largest_file);
    plan.base_source = path.string();
    root.erase("base");
  }
  if (toml::table* sweep = root["sweep"].as_table()) {
    plan.axes = sweep_axes(*sweep, name, problems);
  }
  if (plan.axes.empty() && problems.empty()) {
    throw InvalidInput(name +
                       ": has no [sweep] with the keys that vary, such as "
                       "`cavity.radius = [5, 10]`; `wirepack run` is for one run");
  }
  root.erase("sweep");
  plan.fixed = section_values(root, name, problems);
  require_none(problems);
  return plan;
}

std::vector<std::string> keys_of(const Plan& plan, const std::string& source) {
  std::vector<std::string> keys, problems;
  std::set<std::string> set;
  const auto add = [&](const std::string& key) {
    if (!set.insert(key).second) {
      problems.push_back(
          fmt::format("{}: sweep: {} is given twice", source, plain_text(key, bytes_in_a_message)));
    }
  };
  for (const SweepAxis& axis : plan.axes) {
    keys.insert(keys.end(), axis.keys.begin(), axis.keys.end());
    std::set<std::string> of_axis(axis.keys.begin(), axis.keys.end());
    for (const SweepPoint& point : axis.points) {
      for (const SweepValue& value : point.values) of_axis.insert(value.key);
    }
    std::for_each(of_axis.begin(), of_axis.end(), add);
  }
  require_none(problems);
  return keys;
}

// "cavity.radius" is called radius, unless there is another radius.
std::map<std::string, std::string> short_names(const std::vector<std::string>& keys) {
  const auto last = [](const std::string& key) { return key.substr(key.find('.') + 1); };
  std::map<std::string, int> count;
  for (const std::string& key : keys) ++count[last(key)];
  std::map<std::string, std::string> names;
  for (const std::string& key : keys) names[key] = count[last(key)] > 1 ? key : last(key);
  return names;
}

// Without what shells, file systems or build tools read as something else.
std::string fit_for_a_file(std::string text) {
  for (char& c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '.' || c == '+' || c == '-';
    if (!plain) c = '_';
  }
  return text;
}

/// Makes the tasks of all combinations and gathers what is wrong with them.
class Expansion {
 public:
  Expansion(const Plan& plan, const std::filesystem::path& source)
      : plan_(plan), source_(source), folder_(source.parent_path()) {
    sweep_.keys = keys_of(plan, source.string());
    names_ = short_names(sweep_.keys);
    for (const SweepValue& value : plan.fixed) overrides_.push_back(override_of(value));
  }

  Sweep sweep() {
    std::size_t count = 1;
    for (const SweepAxis& axis : plan_.axes) {
      count = axis.points.empty() || count > most_tasks ? count : count * axis.points.size();
    }
    if (count > most_tasks) {
      throw InvalidInput(fmt::format("{}: has more than {} tasks", source_.string(), most_tasks));
    }
    std::vector<const SweepPoint*> chosen;
    choose(chosen);
    require_none(problems_);
    if (sweep_.tasks.empty()) throw InvalidInput(source_.string() + ": [sweep] makes no task");
    return std::move(sweep_);
  }

 private:
  ConfigOverride override_of(const SweepValue& value) const {
    return {value.key + "=" + value.value, value.where, folder_};
  }

  void choose(std::vector<const SweepPoint*>& chosen) {
    if (chosen.size() == plan_.axes.size()) return add(chosen);
    for (const SweepPoint& point : plan_.axes[chosen.size()].points) {
      chosen.push_back(&point);
      choose(chosen);
      chosen.pop_back();
    }
  }

  void add(const std::vector<const SweepPoint*>& chosen) {
    SweepTask task;
    std::vector<ConfigOverride> overrides = overrides_;
    const auto name = [&](const std::string& key, const std::string& value) {
      task.values.push_back(value);
      task.name += fmt::format("{}{}={}", task.name.empty() ? "" : ",", fit_for_a_file(key),
                               fit_for_a_file(value));
    };
    for (const SweepPoint* point : chosen) {
      if (!point->case_name.empty()) name("case", point->case_name);
      for (const SweepValue& value : point->values) {
        if (point->case_name.empty()) name(names_.at(value.key), value.shown);
        overrides.push_back(override_of(value));
      }
    }
    check_name(task.name);
    try {
      Configuration task_config =
          parse_configuration(plan_.base_text, plan_.base_source, overrides);
      task.scenario = std::move(task_config.scenario);
      task.units = std::move(task_config.units);
    } catch (const InvalidInput& error) {
      std::istringstream lines(error.what());
      for (std::string line; std::getline(lines, line);) complain(line);
    }
    sweep_.tasks.push_back(std::move(task));
  }

  void check_name(const std::string& name) {
    if (name.size() > longest_name) {
      complain(fmt::format("{}: the name of a task is too long: {}; give cases with short names",
                           source_.string(), plain_text(name, bytes_in_a_message)));
    }
    if (!taken_.insert(name).second) {
      complain(
          fmt::format("{}: two tasks would have the name {}; give each value, or entry of a zip, "
                      "once, and values that differ in letters, digits or + - .",
                      source_.string(), plain_text(name, longest_name)));
    }
  }

  // What is wrong with the base is wrong with every task.
  void complain(const std::string& problem) {
    if (told_.insert(problem).second) problems_.push_back(problem);
  }

  const Plan& plan_;
  std::filesystem::path source_, folder_;
  std::vector<ConfigOverride> overrides_;
  std::map<std::string, std::string> names_;
  Sweep sweep_;
  std::set<std::string> taken_, told_;
  std::vector<std::string> problems_;
};

}  // namespace

Sweep parse_sweep(std::string_view text, const std::filesystem::path& source) {
  const Plan plan = read_plan(text, source);
  return Expansion(plan, source).sweep();
}

Sweep read_sweep(const std::filesystem::path& plan) {
  return parse_sweep(read_text(plan, "a plan", largest_file), plan);
}

}  // namespace wirepack
