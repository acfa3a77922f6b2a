#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

class Hdf5Handle;

/// Collects rows and frames of a run and keeps the result file: see data/docs/result_file.md. The
/// file on the disk is never open between two calls, and is only ever replaced as a whole, so it
/// can be read at any moment of the run, also after a kill -9 or on a full disk.
class Hdf5Recorder {
 public:
  /// Begins a new result; a file of that name is replaced by the first flush().
  Hdf5Recorder(const std::filesystem::path& file, const Scenario& scenario,
               std::string command_line);
  /// Goes on with the result in `file`, which must be one of wirepack (see Hdf5Reader), from one of
  /// the progresses that it holds: what lies behind that is dropped. Limits and output of the
  /// scenario may have changed; `command_line` is added as one more line to those kept. The first
  /// flush() makes the file anew, of what wirepack knows in it. Throws FileError.
  static Hdf5Recorder continuing(const std::filesystem::path& file, const Scenario& scenario,
                                 const std::string& command_line, const PackingProgress& from);

  void add(const HistoryRow& row) { rows_.push_back(row); }
  /// A frame is kept under the number of its increment; a second one of the same increment
  /// replaces the first.
  void add(PackingFrame frame) { frames_.push_back(std::move(frame)); }

  /// Keeps a text as an attribute of the file, in place of one of the same name: warnings,
  /// length_unit, force_unit, search_changes.
  void note(const std::string& name, std::string text) { notes_[name] = std::move(text); }

  /// Brings what was added and the progress to the disk, with the reason of the stop if the run is
  /// over. `progress` must be that after the last row added; that of the flush before is kept
  /// beside it, for the case that it gets damaged, or that the run is to go on beyond its end.
  /// Throws FileError with path and reason; then the old file is intact and what was added is kept
  /// for the next flush.
  void flush(const PackingProgress& progress, std::optional<StopReason> stop = std::nullopt);

 private:
  std::shared_ptr<const Hdf5Handle> opened() const;
  void write(const Hdf5Handle& image, const PackingProgress& progress,
             std::optional<StopReason> stop) const;

  std::filesystem::path file_;
  Scenario scenario_;
  std::string command_line_;
  bool exists_ = false;  // our file is in place, and the next flush adds to it
  std::optional<double>
      kept_up_to_;  // the next flush makes it anew, with frames up to this increment
  std::shared_ptr<const Hdf5Handle> image_;  // of the file, in memory; none: it has to be read
  std::vector<HistoryColumn> columns_;
  std::shared_ptr<const char> identity_;  // its place is like no other recorder's
  std::optional<PackingProgress> last_, before_;
  std::vector<HistoryRow> rows_;
  std::vector<PackingFrame> frames_;
  std::map<std::string, std::string> notes_;
};

}  // namespace wirepack
