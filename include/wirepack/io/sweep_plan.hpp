#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/packing/declared_units.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// One run of a sweep.
struct SweepTask {
  std::string name;                 ///< "setup=low_torsion,radius=10,seed=1": fit for a folder
  std::vector<std::string> values;  ///< of the keys that the sweep varies; empty where not given
  Scenario scenario;
  DeclaredUnits units;
};

/// Many runs that differ in some keys of the configuration.
struct Sweep {
  std::vector<std::string> keys;  ///< "cavity.radius"; named cases have the key "case"
  std::vector<SweepTask> tasks;   ///< the last key varies fastest
};

/// The sweep of a TOML plan (data/docs/sweep.md has the format): a configuration, with the file
/// `base` below it if that is given, and in [sweep] the keys that vary: lists and ranges, all
/// combinations of which are run; [[sweep.zip]], whose lists go together; [sweep.cases.NAME].
/// Names of files are relative to the folder of the plan, those in the base to the base's.
///
/// Throws InvalidInput with one line per problem, "file:line:column: what is wrong", in the plan
/// itself or in the configuration of any task; FileError when reading the base fails.
Sweep parse_sweep(std::string_view text, const std::filesystem::path& source);

/// parse_sweep() of a file.
Sweep read_sweep(const std::filesystem::path& plan);

}  // namespace wirepack
