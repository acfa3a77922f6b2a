#include "wirepack/io/export.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"

#include "../atomic_file.hpp"

namespace wirepack {

namespace {

std::vector<std::string> provenance(const Hdf5Reader& reader, const std::string& result,
                                    const Scenario& scenario) {
  const std::string state = reader.finished() ? "ended by " + reader.stop_reason() : "not finished";
  return {
      plain_text(
          fmt::format("wirepack {}, commit {}", reader.program_version(), reader.git_commit())),
      plain_text(fmt::format("from {}, a run {}, seed {}", result, state, scenario.seed)),
      plain_text(fmt::format("command: {}", reader.command_line())),
      fmt::format("units of the configuration: wire radius a = {}, Young's modulus Y = {}, cavity "
                  "radius R = {}",
                  scenario.wire.radius, scenario.wire.youngs_modulus, scenario.cavity.radius)};
}

}  // namespace

ExportSource export_source(const Hdf5Reader& reader, const std::filesystem::path& result,
                           const std::filesystem::path& target,
                           const std::vector<std::int64_t>& increments) {
  ExportSource source;
  source.result = result;
  source.target = target;
  source.scenario = reader.scenario();
  source.provenance = provenance(reader, result.string(), source.scenario);
  source.history = reader.history();
  for (const std::int64_t increment : increments) source.frames.push_back(reader.frame(increment));
  return source;
}

void write_files(const ExportedFiles& files) {
  std::vector<std::filesystem::path> made;
  try {
    for (const ExportedFile& file : files) {
      const std::filesystem::path folder = file.path.parent_path();
      if (!folder.empty() && make_folder(folder)) made.push_back(folder);
      const bool is_new = !std::filesystem::exists(file.path);
      replace_file(file.path, std::vector<char>(file.bytes.begin(), file.bytes.end()));
      if (is_new) made.push_back(file.path);
    }
  } catch (const FileError&) {
    std::error_code ignored;
    std::reverse(made.begin(), made.end());
    for (const std::filesystem::path& path : made) std::filesystem::remove(path, ignored);
    throw;
  }
}

}  // namespace wirepack
