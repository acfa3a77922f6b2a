#include "wirepack/io/hdf5_recorder.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "wirepack/core/version.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/packing/imperfection.hpp"

#include "atomic_file.hpp"
#include "checkpoint.hpp"
#include "hdf5_image.hpp"
#include "hdf5_values.hpp"
#include "result_format.hpp"

namespace wirepack {

namespace {

Hdf5Table<double> list_of(const Eigen::VectorXd& values) {
  return {std::vector<double>(values.data(), values.data() + values.size()),
          static_cast<hsize_t>(values.size()), 0};
}

// A rename replaces a link to a file, but the file that it leads to is meant.
std::filesystem::path resolved(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path target = std::filesystem::canonical(file, error);
  return error ? file : target;
}

template <class T>
std::vector<T> column_of(const std::vector<HistoryRow>& rows, double HistoryRow::*member) {
  std::vector<T> values(rows.size());
  std::transform(rows.begin(), rows.end(), values.begin(),
                 [member](const HistoryRow& row) { return static_cast<T>(row.*member); });
  return values;
}

void write_history(hid_t file, const std::vector<HistoryColumn>& columns,
                   const std::vector<HistoryRow>& rows) {
  const Hdf5Handle history = open_or_create_group(file, "history");
  const bool begun = has_link(history, std::string(columns.front().name));
  for (const HistoryColumn& column : columns) {
    const std::string name(column.name);
    const bool is_new = !has_link(history, name);
    // a file that was begun without the column goes on without it: columns are equally long
    if (is_new && column.added_later && begun) continue;
    if (column.integer) {
      append_values(history, name, column_of<std::int64_t>(rows, column.value));
    } else {
      append_values(history, name, column_of<double>(rows, column.value));
    }
    if (!is_new) continue;
    const Hdf5Handle dataset(H5Dopen2(history, name.c_str(), H5P_DEFAULT), H5Dclose,
                             "opening " + name);
    write_attribute(dataset, "unit", std::string(column.unit));
  }
}

void write_frame(hid_t frames, const PackingFrame& frame) {
  const std::string name = fmt::format("{:06}", static_cast<std::int64_t>(frame.increment));
  if (has_link(frames, name)) remove_link(frames, name);
  const Hdf5Handle group = open_or_create_group(frames, name);
  write_attribute(group, "increment", static_cast<std::int64_t>(frame.increment));
  write_attribute(group, "inserted_length", frame.inserted_length);
  write_attribute(group, "packing_density", frame.packing_density);
  write_attribute(group, "force", frame.force);
  write_table(group, "position", table_of(frame.rod.nodes));
  write_table(group, "quaternion", table_of(frame.rod.frames, frame.rod.edge_count()));
  write_table(group, "bend_energy", list_of(frame.bend_energy));
  write_table(group, "twist_energy", list_of(frame.twist_energy));
  write_table(group, "wall_force", list_of(frame.wall_force));
  Hdf5Table<std::int64_t> pairs{{}, frame.contacts.size(), 2};
  Hdf5Table<double> forces{{}, frame.contacts.size(), 0};
  for (const SelfContact& contact : frame.contacts) {
    pairs.values.push_back(contact.edges.first);
    pairs.values.push_back(contact.edges.second);
    forces.values.push_back(contact.force);
  }
  write_table(group, "contact_pairs", pairs);
  write_table(group, "contact_force", forces);
}

void write_provenance(hid_t file, const Scenario& scenario, const std::string& command_line) {
  const Version build = version();
  write_attribute(file, "format", std::string(result_format));
  write_attribute(file, "format_version", result_format_version);
  write_attribute(file, "program_version", std::string(build.program));
  write_attribute(file, "git_commit", std::string(build.git_commit));
  write_attribute(file, "library_versions", std::string(build.libraries));
  write_attribute(file, "command_line", command_line);
  write_attribute(file, "config", resolved_config(scenario));
  write_attribute(file, "seed", static_cast<std::int64_t>(scenario.seed));
}

void write_setup(hid_t file, const Scenario& scenario) {
  const Hdf5Handle group = open_or_create_group(file, "setup");
  const DrawnSetup drawn = drawn_setup(scenario);
  replace_table(group, "rest_darboux", list_of(drawn.wire.rest_darboux));
  replace_table(group, "nozzle_position", list_of(drawn.nozzle.position));
  replace_table(group, "nozzle_direction", list_of(drawn.nozzle.direction));
}

}  // namespace

Hdf5Recorder::Hdf5Recorder(const std::filesystem::path& file, const Scenario& scenario,
                           std::string command_line)
    : file_(resolved(file)), scenario_(scenario), command_line_(std::move(command_line)) {}

Hdf5Recorder Hdf5Recorder::continuing(const std::filesystem::path& file, const Scenario& scenario,
                                      const std::string& command_line) {
  const std::string before = Hdf5Reader(file).command_line();
  Hdf5Recorder recorder(file, scenario, before + "\n" + command_line);
  recorder.exists_ = true;
  remove_leftovers(recorder.file_);
  return recorder;
}

void Hdf5Recorder::flush(const PackingProgress& progress, std::optional<StopReason> stop) {
  const QuietHdf5 quiet;
  std::vector<char> bytes;
  if (exists_) bytes = read_bytes(file_);
  try {
    const Hdf5Handle image = exists_ ? open_image(bytes) : create_image();
    write_provenance(image, scenario_, command_line_);
    write_setup(image, scenario_);
    for (const auto& [name, text] : notes_) write_attribute(image, name, text);
    write_attribute(image, "finished", static_cast<std::int64_t>(stop.has_value()));
    write_attribute(image, "stop_reason", stop ? std::string(name_of(*stop)) : std::string());
    write_attribute(image, "phi_max", progress.last.packing_density);
    write_history(image, columns_of(scenario_), rows_);
    const Hdf5Handle frames = open_or_create_group(image, "frames");
    for (const PackingFrame& frame : frames_) write_frame(frames, frame);
    write_progress(image, progress, units_of(scenario_));
    bytes = bytes_of_image(image);
  } catch (const FileError& error) {
    throw FileError(file_.string() + ": cannot be written: " + error.what());
  }
  replace_file(file_, bytes);
  exists_ = true;
  rows_.clear();
  frames_.clear();
}

}  // namespace wirepack
