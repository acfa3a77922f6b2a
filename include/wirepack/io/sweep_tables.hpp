#pragma once

#include <filesystem>
#include <vector>

namespace wirepack {

/// Tables of a sweep as CSV, in its folder under tables/ (data/docs/sweep.md has the columns):
///   runs.csv    a line for each task: its keys, state and last increment
///   seeds.csv   the same over the seeds: mean, standard deviation, smallest and largest
///   curves.csv  force and energies against the packing density, over the seeds
/// Only finished runs count in the last two. Returns the files; throws FileError, InvalidInput.
std::vector<std::filesystem::path> write_sweep_tables(const std::filesystem::path& folder);

}  // namespace wirepack
