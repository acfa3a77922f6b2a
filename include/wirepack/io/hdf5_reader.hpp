#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Reads a result file. What is read is what was written: it has checksums since format version 3,
/// and its values are looked at. Nothing but the file itself is opened. It stays on the file it has
/// opened, also when a run replaces that by a newer one. Everything throws FileError with the path
/// and what is wrong: missing, not HDF5, not of wirepack, of another format version, damaged.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);
  ~Hdf5Reader();
  Hdf5Reader(Hdf5Reader&&) noexcept;

  std::vector<HistoryRow> history() const;
  /// Increments of which there is a frame, in order.
  std::vector<std::int64_t> frame_increments() const;
  /// One of them. Of the contacts it has edges and force; the rod has no clamp frames and no twist
  /// guide.
  PackingFrame frame(std::int64_t increment) const;
  bool has_column(const std::string& name) const;
  /// Where the run was at the last flush, for its continuation; where that is damaged, and there is
  /// one, progress_before().
  PackingProgress progress() const;
  /// Where the run was at the flush before; of a finished run, before its last increment. Nothing:
  /// there is none, or it is damaged.
  std::optional<PackingProgress> progress_before() const;
  /// What is wrong with where the run was at the last flush. Empty: nothing.
  std::string damage() const;

  std::string config() const;  ///< resolved TOML text
  Scenario scenario() const;   ///< what config() says
  std::string command_line() const;
  std::string program_version() const;
  std::string git_commit() const;
  std::string library_versions() const;
  bool finished() const;
  std::string stop_reason() const;  ///< empty while the run is not finished
  double phi_max() const;
  /// What Hdf5Recorder::note() has kept; empty when there is none of this name.
  std::string note(const std::string& name) const;

 private:
  struct Opened;
  PackingProgress checkpoint(const std::string& group) const;
  std::unique_ptr<Opened> opened_;
};

}  // namespace wirepack
