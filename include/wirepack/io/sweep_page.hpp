#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wirepack/io/sweep_status.hpp"

namespace wirepack {

/// A line of a sweep's page.
struct SweepPageTask {
  std::string name;
  TaskStatus status;
  double seconds_left;  ///< negative: nobody knows
};

/// Hours of a time, with three decimals; "?" of a negative one.
std::string shown_hours(double seconds);

/// Writes status.html into the folder of a sweep, in place of an earlier one: state, density and
/// hours of its tasks, a small picture of each wire (seen along y) and a small curve of its force.
/// The picture leads to TASK/view.html, the run's page (update_view_page). Returns its path; throws
/// FileError.
std::filesystem::path write_sweep_page(const std::filesystem::path& folder,
                                       const std::string& summary,
                                       const std::vector<SweepPageTask>& tasks);

}  // namespace wirepack
