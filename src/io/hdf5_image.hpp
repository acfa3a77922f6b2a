#pragma once

#include <vector>

#include "hdf5_handle.hpp"

namespace wirepack {

// Result files are changed in memory and put in place as a whole: HDF5 itself never writes to the
// disk, so a full disk cannot leave it with a file it can neither finish nor close.

/// A new, empty HDF5 file in memory.
Hdf5Handle create_image();
/// A writable copy in memory of an HDF5 file given as its bytes.
Hdf5Handle open_image(std::vector<char>& bytes);
/// The bytes of a file in memory.
std::vector<char> bytes_of_image(hid_t file);

}  // namespace wirepack
