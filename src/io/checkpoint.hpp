#pragma once

#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/units.hpp"

#include "hdf5_values.hpp"

namespace wirepack {

/// Writes a group that holds all of a progress, bit for bit, in units of the wire. What was there
/// is replaced.
void write_checkpoint(hid_t file, const std::string& group, const PackingProgress& progress);
/// Writes what readers look at: /balance in `units`, those of the configuration, /crossings and
/// /work.
void write_shown(hid_t file, const PackingProgress& progress, const Units& units);
/// In the units of the checkpoint: those of the configuration in files of format version 1. Throws
/// FileError where the group has no progress that a run can have.
PackingProgress read_checkpoint(hid_t file, const std::string& group);

}  // namespace wirepack
