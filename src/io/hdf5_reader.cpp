#include "wirepack/io/hdf5_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

#include "wirepack/core/error.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/packing/own_units.hpp"

#include "checkpoint.hpp"
#include "config_text.hpp"
#include "hdf5_checksum.hpp"
#include "hdf5_safety.hpp"
#include "hdf5_values.hpp"
#include "progress_tables.hpp"
#include "result_format.hpp"
#include "saved_values.hpp"

namespace wirepack {

struct Hdf5Reader::Opened {
  std::string name;
  Hdf5Handle file;
  std::int64_t version;
  // read once
  std::optional<std::vector<HistoryRow>> history = {};
  std::optional<Scenario> scenario = {};

  /// What has the attributes that are read.
  Hdf5Handle facts() const { return open_group(file, version < 3 ? "/" : provenance_group); }
};

namespace {

Hdf5Handle open_result(const std::filesystem::path& path) {
  const QuietHdf5 quiet;
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw FileError(name + ": there is no such file");
  }
  if (!std::filesystem::is_regular_file(status)) throw FileError(name + ": is not a file");
  if (!std::ifstream(path)) {
    throw FileError(name + ": cannot be opened: " + std::strerror(errno));
  }
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "preparing to read");
  // Result files are only ever replaced as a whole, so there is nothing to lock; some file systems
  // of clusters cannot lock at all.
  hdf5_checked(H5Pset_file_locking(access, false, true), "preparing to read");
  const hid_t file = H5Fopen(name.c_str(), H5F_ACC_RDONLY, access);
  if (file < 0) {
    throw FileError(name + (H5Fis_hdf5(name.c_str()) > 0
                                ? ": is damaged: its HDF5 structure cannot be read"
                                : ": is not an HDF5 file"));
  }
  return {file, H5Fclose, "opening"};
}

// Runs a reading function; what goes wrong in it is a damage of the file.
template <class F>
auto reading(const std::string& name, F&& f) {
  const QuietHdf5 quiet;
  try {
    return f();
  } catch (const FileError& error) {
    throw FileError(name + ": is damaged: " + error.what());
  } catch (const NumericalFailure& error) {  // numbers of a state that cannot be
    throw FileError(name + ": is damaged: " + error.what());
  }
}

std::string read_text(hid_t file, std::int64_t version, const std::string& name) {
  if (version < 3) return read_text_attribute(file, name);
  return read_fixed_text(open_group(file, provenance_group), name);
}

/// The version of its format, of a file that is one of wirepack.
std::int64_t version_of(hid_t file, const std::string& name) {
  const QuietHdf5 quiet;
  std::string format;
  std::int64_t version = 0;
  try {
    version = read_attribute<std::int64_t>(file, "format_version");
    format = read_text(file, has_link(file, provenance_group) ? 3 : 2, "format");
  } catch (const FileError&) {
    format.clear();
  }
  if (format != result_format) throw FileError(name + ": is not a result file of wirepack");
  if (version < 1 || version > result_format_version) {
    throw FileError(fmt::format("{}: has format version {}; this wirepack reads versions 1 to {}",
                                name, version, result_format_version));
  }
  return version;
}

std::string frame_name(std::int64_t increment) { return fmt::format("{:06}", increment); }

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Index>(values.size()));
}

PackingFrame read_frame(hid_t group) {
  PackingFrame frame;
  frame.increment = static_cast<double>(read_attribute<std::int64_t>(group, "increment"));
  frame.inserted_length = read_attribute<double>(group, "inserted_length");
  frame.packing_density = read_attribute<double>(group, "packing_density");
  frame.force = read_attribute<double>(group, "force");
  frame.rod.nodes = points_of(read_table<double>(group, "position", 3));
  frame.rod.frames = rotations_of(read_table<double>(group, "quaternion", 4));
  frame.bend_energy = vector_of(read_table<double>(group, "bend_energy", 0).values);
  frame.twist_energy = vector_of(read_table<double>(group, "twist_energy", 0).values);
  frame.wall_force = vector_of(read_table<double>(group, "wall_force", 0).values);
  const auto pairs = read_table<std::int64_t>(group, "contact_pairs", 2);
  const auto forces = read_table<double>(group, "contact_force", 0);
  if (pairs.rows != forces.rows) throw FileError("a frame has lists of unfitting lengths");
  for (std::size_t i = 0; i < forces.values.size(); ++i) {
    SelfContact contact{};
    contact.edges = {pairs.values[2 * i], pairs.values[2 * i + 1]};
    contact.force = forces.values[i];
    frame.contacts.push_back(contact);
  }
  check_frame(frame);
  return frame;
}

// A checkpoint belongs to a row of the history, the last one to the last row.
void check_place(const HistoryRow& last, const std::vector<HistoryRow>& rows, const Units& units,
                 bool is_last) {
  const auto count = static_cast<double>(rows.size());
  const bool fits =
      is_last ? last.increment == count : 0 <= last.increment && last.increment <= count;
  if (!fits || last.increment != std::floor(last.increment)) {
    throw FileError("a checkpoint and the history are of different increments");
  }
  if (last.increment == 0) return;
  const double length = rows[static_cast<std::size_t>(last.increment) - 1].inserted_length;
  if (std::abs(last.inserted_length * units.length - length) > 1e-9 * length) {
    throw FileError("a checkpoint and the history have different lengths of wire");
  }
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
    : opened_(std::make_unique<Opened>(Opened{file.string(), open_result(file), 0})) {
  reading(opened_->name, [&] { check_safety(opened_->file); });
  opened_->version = version_of(opened_->file, opened_->name);
  if (opened_->version < 3) return;
  reading(opened_->name, [&] {
    const Hdf5Handle facts = opened_->facts();
    verify_checksum(facts);
    if (read_attribute<std::int64_t>(facts, "format_version") != opened_->version) {
      throw FileError("it tells two versions of its format");
    }
  });
}
Hdf5Reader::~Hdf5Reader() = default;
Hdf5Reader::Hdf5Reader(Hdf5Reader&&) noexcept = default;

std::vector<HistoryRow> Hdf5Reader::history() const {
  if (opened_->history) return *opened_->history;
  return opened_->history.emplace(reading(opened_->name, [&] {
    const Hdf5Handle group = open_group(opened_->file, "history");
    if (opened_->version >= 3) verify_checksum(group);
    std::vector<HistoryRow> rows;
    bool first = true;
    for (const HistoryColumn& column : history_columns) {
      const bool optional = column.of != ColumnOf::every_run || column.added_later;
      if (optional && !has_link(group, std::string(column.name))) continue;
      // integers are converted to double by HDF5
      const auto table = read_table<double>(group, std::string(column.name), 0);
      if (first) rows.resize(table.values.size());
      first = false;
      if (table.values.size() != rows.size()) {
        throw FileError("the columns of its history differ in length");
      }
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*column.value = table.values[i];
    }
    check_history(rows);
    return rows;
  }));
}

std::vector<std::int64_t> Hdf5Reader::frame_increments() const {
  return reading(opened_->name, [&] {
    std::vector<std::int64_t> increments;
    for (const std::string& name : links_of(open_group(opened_->file, "frames"))) {
      std::int64_t number = 0;
      const char* end = name.data() + name.size();
      const auto [stopped, status] = std::from_chars(name.data(), end, number);
      if (status != std::errc() || stopped != end) throw FileError("it has a frame " + name);
      increments.push_back(number);
    }
    std::sort(increments.begin(), increments.end());
    return increments;
  });
}

PackingFrame Hdf5Reader::frame(std::int64_t increment) const {
  return reading(opened_->name, [&] {
    const Hdf5Handle frames = open_group(opened_->file, "frames");
    const Hdf5Handle group = open_group(frames, frame_name(increment));
    if (has_attribute(group, "checksum")) verify_checksum(group);  // since format version 3
    PackingFrame frame = read_frame(group);
    if (frame.increment != static_cast<double>(increment)) {
      throw FileError("a frame is that of another increment");
    }
    return frame;
  });
}

bool Hdf5Reader::has_column(const std::string& name) const {
  return reading(opened_->name,
                 [&] { return has_link(open_group(opened_->file, "history"), name); });
}

PackingProgress Hdf5Reader::checkpoint(const std::string& group) const {
  const std::vector<HistoryRow> rows = history();
  const Units units = units_of(scenario());
  return reading(opened_->name, [&] {
    if (opened_->version >= 3) verify_checksum(open_group(opened_->file, group));
    PackingProgress progress = read_checkpoint(opened_->file, group);
    if (opened_->version == 1) progress = in_own_units(std::move(progress), units);
    check_place(progress.last, rows, units, group == checkpoint_group);
    return progress;
  });
}

PackingProgress Hdf5Reader::progress() const {
  try {
    return checkpoint(checkpoint_group);
  } catch (const FileError&) {
    if (!has_link(opened_->file, checkpoint_before_group)) throw;
  }
  return checkpoint(checkpoint_before_group);
}

std::optional<PackingProgress> Hdf5Reader::progress_before() const {
  if (!has_link(opened_->file, checkpoint_before_group)) return std::nullopt;
  try {
    return checkpoint(checkpoint_before_group);
  } catch (const FileError&) {  // the last one is enough
    return std::nullopt;
  }
}

std::string Hdf5Reader::damage() const {
  try {
    checkpoint(checkpoint_group);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

namespace {

std::string text(const std::string& file_name, hid_t file, std::int64_t version,
                 const std::string& name) {
  return reading(file_name, [&] { return read_text(file, version, name); });
}

}  // namespace

std::string Hdf5Reader::config() const {
  return text(opened_->name, opened_->file, opened_->version, "config");
}

Scenario Hdf5Reader::scenario() const {
  if (opened_->scenario) return *opened_->scenario;
  try {
    const std::string text = config();
    // Shapes are written out in a result, so that nothing but the result itself is read.
    for (const GivenKey& key : read_config_text(text, "config", {}).keys) {
      if (key.name == "reference_shape" && key.value &&
          std::holds_alternative<std::string>(*key.value)) {
        throw InvalidInput(key.where + ": wire.reference_shape is the name of a file");
      }
    }
    return opened_->scenario.emplace(parse_config(text, "config"));
  } catch (const InvalidInput& error) {
    throw FileError(opened_->name +
                    ": its configuration is not one of this version: " + error.what());
  }
}

std::string Hdf5Reader::command_line() const {
  return text(opened_->name, opened_->file, opened_->version, "command_line");
}
std::string Hdf5Reader::program_version() const {
  return text(opened_->name, opened_->file, opened_->version, "program_version");
}
std::string Hdf5Reader::git_commit() const {
  return text(opened_->name, opened_->file, opened_->version, "git_commit");
}
std::string Hdf5Reader::library_versions() const {
  return text(opened_->name, opened_->file, opened_->version, "library_versions");
}
std::string Hdf5Reader::stop_reason() const {
  return text(opened_->name, opened_->file, opened_->version, "stop_reason");
}
std::string Hdf5Reader::note(const std::string& name) const {
  const bool there = reading(opened_->name, [&] { return has_attribute(opened_->facts(), name); });
  return there ? text(opened_->name, opened_->file, opened_->version, name) : std::string();
}
bool Hdf5Reader::finished() const {
  return reading(opened_->name,
                 [&] { return read_attribute<std::int64_t>(opened_->facts(), "finished") != 0; });
}
double Hdf5Reader::phi_max() const {
  return reading(opened_->name,
                 [&] { return read_attribute<double>(opened_->facts(), "phi_max"); });
}

}  // namespace wirepack
