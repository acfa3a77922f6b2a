#include "wirepack/io/hdf5_reader.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <system_error>

#include "wirepack/core/error.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/packing/own_units.hpp"

#include "checkpoint.hpp"
#include "hdf5_values.hpp"
#include "result_format.hpp"

namespace wirepack {

struct Hdf5Reader::Opened {
  std::string name;
  Hdf5Handle file;
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
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "preparing to read");
  // Result files are only ever replaced as a whole, so there is nothing to lock; some file systems
  // of clusters cannot lock at all.
  hdf5_checked(H5Pset_file_locking(access, false, true), "preparing to read");
  const hid_t file = H5Fopen(name.c_str(), H5F_ACC_RDONLY, access);
  if (file < 0) {
    throw FileError(name + (H5Fis_hdf5(name.c_str()) > 0
                                ? ": is damaged: its HDF5 structure cannot be read"
                                : ": is not an HDF5 file, or cannot be read"));
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

std::int64_t version_of(hid_t file) { return read_attribute<std::int64_t>(file, "format_version"); }

void require_format(hid_t file, const std::string& name) {
  const QuietHdf5 quiet;
  std::string format;
  std::int64_t version = 0;
  try {
    format = read_text_attribute(file, "format");
    version = version_of(file);
  } catch (const FileError&) {
    format.clear();
  }
  if (format != result_format) throw FileError(name + ": is not a result file of wirepack");
  if (version < 1 || version > result_format_version) {
    throw FileError(fmt::format("{}: has format version {}; this wirepack reads versions 1 to {}",
                                name, version, result_format_version));
  }
}

herr_t note_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
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
  const Index n = frame.rod.node_count();
  const bool fits = n >= 2 && static_cast<Index>(frame.rod.frames.size()) == n - 1 &&
                    frame.bend_energy.size() == n && frame.twist_energy.size() == n &&
                    frame.wall_force.size() == n && pairs.rows == forces.rows;
  if (!fits) throw FileError("a frame has lists of unfitting lengths");
  for (std::size_t i = 0; i < forces.values.size(); ++i) {
    SelfContact contact{};
    contact.edges = {pairs.values[2 * i], pairs.values[2 * i + 1]};
    contact.force = forces.values[i];
    if (contact.edges.first < 0 || contact.edges.second >= n - 1 ||
        contact.edges.first >= contact.edges.second) {
      throw FileError("a frame has a contact of edges that are not there");
    }
    frame.contacts.push_back(contact);
  }
  return frame;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
    : opened_(std::make_unique<Opened>(Opened{file.string(), open_result(file)})) {
  require_format(opened_->file, opened_->name);
}
Hdf5Reader::~Hdf5Reader() = default;
Hdf5Reader::Hdf5Reader(Hdf5Reader&&) noexcept = default;

std::vector<HistoryRow> Hdf5Reader::history() const {
  return reading(opened_->name, [&] {
    const Hdf5Handle group = open_group(opened_->file, "history");
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
    return rows;
  });
}

std::vector<std::int64_t> Hdf5Reader::frame_increments() const {
  return reading(opened_->name, [&] {
    const Hdf5Handle group = open_group(opened_->file, "frames");
    std::vector<std::string> names;
    hdf5_checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_name, &names),
                 "listing the frames");
    std::vector<std::int64_t> increments;
    for (const std::string& name : names) {
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
    return read_frame(open_group(frames, frame_name(increment)));
  });
}

PackingProgress Hdf5Reader::progress() const {
  return reading(opened_->name, [&] {
    PackingProgress progress = read_progress(opened_->file);
    if (version_of(opened_->file) == 1) {
      progress = in_own_units(std::move(progress), units_of(scenario()));
    }
    check_state(progress.rod);
    return progress;
  });
}

namespace {

std::string text(const std::string& file_name, hid_t file, const char* attribute) {
  return reading(file_name, [&] { return read_text_attribute(file, attribute); });
}

}  // namespace

std::string Hdf5Reader::config() const { return text(opened_->name, opened_->file, "config"); }

Scenario Hdf5Reader::scenario() const {
  try {
    return parse_config(config(), "config");
  } catch (const InvalidInput& error) {
    throw FileError(opened_->name +
                    ": its configuration is not one of this version: " + error.what());
  }
}

std::string Hdf5Reader::command_line() const {
  return text(opened_->name, opened_->file, "command_line");
}
std::string Hdf5Reader::program_version() const {
  return text(opened_->name, opened_->file, "program_version");
}
std::string Hdf5Reader::git_commit() const {
  return text(opened_->name, opened_->file, "git_commit");
}
std::string Hdf5Reader::library_versions() const {
  return text(opened_->name, opened_->file, "library_versions");
}
std::string Hdf5Reader::stop_reason() const {
  return text(opened_->name, opened_->file, "stop_reason");
}
std::string Hdf5Reader::note(const std::string& name) const {
  if (!has_attribute(opened_->file, name)) return {};
  return text(opened_->name, opened_->file, name.c_str());
}
bool Hdf5Reader::finished() const {
  return reading(opened_->name,
                 [&] { return read_attribute<std::int64_t>(opened_->file, "finished") != 0; });
}
double Hdf5Reader::phi_max() const {
  return reading(opened_->name, [&] { return read_attribute<double>(opened_->file, "phi_max"); });
}

}  // namespace wirepack
