#include "wirepack/io/hdf5_recorder.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "wirepack/core/version.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/packing/imperfection.hpp"

#include "atomic_file.hpp"
#include "checkpoint.hpp"
#include "hdf5_checksum.hpp"
#include "hdf5_image.hpp"
#include "hdf5_safety.hpp"
#include "hdf5_values.hpp"
#include "progress_tables.hpp"
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
  for (const HistoryColumn& column : columns) {
    const std::string name(column.name);
    const bool is_new = !has_link(history, name);
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
  write_checksum(history);
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
  write_checksum(group);
}

/// Writes attributes of / for all readers, and again with a checksum for Hdf5Reader.
class Facts {
 public:
  explicit Facts(hid_t file)
      : file_(file), provenance_(open_or_create_group(file, provenance_group)) {}
  void write(const std::string& name, const std::string& text) {
    write_attribute(file_, name, text);
    write_fixed_text(provenance_, name, text);
  }
  template <class Number>
  void write(const std::string& name, Number value) {
    write_attribute(file_, name, value);
    write_attribute(provenance_, name, value);
  }
  void seal() { write_checksum(provenance_); }

 private:
  hid_t file_;
  Hdf5Handle provenance_;
};

void write_provenance(Facts& facts, const Scenario& scenario, const std::string& command_line) {
  const Version build = version();
  facts.write("format", std::string(result_format));
  facts.write("format_version", result_format_version);
  facts.write("program_version", std::string(build.program));
  facts.write("git_commit", std::string(build.git_commit));
  facts.write("library_versions", std::string(build.libraries));
  facts.write("command_line", command_line);
  facts.write("config", resolved_config(scenario));
  facts.write("seed", static_cast<std::int64_t>(scenario.seed));
}

void write_setup(hid_t file, const Scenario& scenario) {
  const Hdf5Handle group = open_or_create_group(file, "setup");
  const DrawnSetup drawn = drawn_setup(scenario);
  replace_table(group, "rest_darboux", list_of(drawn.wire.rest_darboux));
  replace_table(group, "nozzle_position", list_of(drawn.nozzle.position));
  replace_table(group, "nozzle_direction", list_of(drawn.nozzle.direction));
}

/// A new image with the frames of an old one up to an increment.
Hdf5Handle image_with_frames(std::vector<char>& bytes, const std::string& name,
                             double last_increment) {
  const Hdf5Handle old = open_image(bytes, name + " before");
  check_safety(old);
  Hdf5Handle image = create_image(name);
  hdf5_checked(H5Ocopy(old, "frames", image, "frames", H5P_DEFAULT, H5P_DEFAULT),
               "taking over its frames");
  const Hdf5Handle frames = open_group(image, "frames");
  for (const std::string& increment : links_of(frames)) {
    if (std::stod(increment) > last_increment) remove_link(frames, increment);
  }
  return image;
}

}  // namespace

Hdf5Recorder::Hdf5Recorder(const std::filesystem::path& file, const Scenario& scenario,
                           std::string command_line)
    : file_(resolved(file)),
      scenario_(scenario),
      command_line_(std::move(command_line)),
      columns_(columns_of(scenario)),
      identity_(std::make_shared<const char>()) {}

Hdf5Recorder Hdf5Recorder::continuing(const std::filesystem::path& file, const Scenario& scenario,
                                      const std::string& command_line,
                                      const PackingProgress& from) {
  const Hdf5Reader reader(file);
  Hdf5Recorder recorder(file, scenario, reader.command_line() + "\n" + command_line);
  recorder.exists_ = true;
  recorder.kept_up_to_ = from.last.increment;
  recorder.rows_ = reader.history();
  reader.frame_increments();  // all names are numbers
  recorder.rows_.resize(static_cast<std::size_t>(from.last.increment));
  // a file that was begun without a column goes on without it: columns are equally long
  std::erase_if(recorder.columns_, [&](const HistoryColumn& column) {
    return column.added_later && !reader.has_column(std::string(column.name));
  });
  recorder.last_ = from;
  recorder.before_ = reader.progress_before();
  remove_leftovers(recorder.file_);
  return recorder;
}

std::shared_ptr<const Hdf5Handle> Hdf5Recorder::opened() const {
  const std::string name = fmt::format("wirepack-result-in-memory-{}", fmt::ptr(identity_.get()));
  if (!exists_) return std::make_shared<const Hdf5Handle>(create_image(name));
  std::vector<char> bytes = read_bytes(file_);
  return std::make_shared<const Hdf5Handle>(
      kept_up_to_ ? image_with_frames(bytes, name, *kept_up_to_) : open_image(bytes, name));
}

void Hdf5Recorder::write(const Hdf5Handle& image, const PackingProgress& progress,
                         std::optional<StopReason> stop) const {
  Facts facts(image);
  write_provenance(facts, scenario_, command_line_);
  for (const auto& [name, text] : notes_) facts.write(name, text);
  facts.write("finished", static_cast<std::int64_t>(stop.has_value()));
  facts.write("stop_reason", stop ? std::string(name_of(*stop)) : std::string());
  facts.write("phi_max", progress.last.packing_density);
  facts.seal();
  write_setup(image, scenario_);
  write_history(image, columns_, rows_);
  const Hdf5Handle frames = open_or_create_group(image, "frames");
  for (const PackingFrame& frame : frames_) write_frame(frames, frame);
  write_checkpoint(image, checkpoint_group, progress);
  if (before_) {
    write_checkpoint(image, checkpoint_before_group, *before_);
  } else if (has_link(image, checkpoint_before_group)) {
    remove_link(image, checkpoint_before_group);
  }
  write_shown(image, progress, units_of(scenario_));
}

void Hdf5Recorder::flush(const PackingProgress& progress, std::optional<StopReason> stop) {
  const QuietHdf5 quiet;
  if (last_ && last_->last.increment < progress.last.increment) before_ = last_;
  // What comes behind it is dropped; and how far a run that is lost was saved before is a matter of
  // time.
  const bool lost = stop == StopReason::no_equilibrium || stop == StopReason::strands_passed;
  if (lost || (before_ && before_->last.increment >= progress.last.increment)) before_.reset();
  last_ = progress;
  // What is in memory counts only if it gets to the disk.
  std::shared_ptr<const Hdf5Handle> image = std::exchange(image_, nullptr);
  std::span<const char> bytes;
  try {
    if (image == nullptr) image = opened();
    write(*image, progress, stop);
    bytes = bytes_of_image(*image);
  } catch (const FileError& error) {
    throw FileError(file_.string() + ": cannot be written: " + error.what());
  }
  replace_file(file_, bytes);
  image_ = image;
  exists_ = true;
  kept_up_to_.reset();
  rows_.clear();
  frames_.clear();
}

}  // namespace wirepack
