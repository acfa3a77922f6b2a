#pragma once

#include "hdf5_handle.hpp"

namespace wirepack {

// HDF5 checks its own structures and chunks, but not that they belong together: a group keeps a
// checksum (CRC-32, attribute "checksum") over the names and values of its attributes and datasets,
// and of those of the groups within it. Texts of variable length, which are for other readers, are
// left out.

void write_checksum(hid_t group);
/// Throws FileError when there is no checksum, or another one than `group` now has.
void verify_checksum(hid_t group);

}  // namespace wirepack
