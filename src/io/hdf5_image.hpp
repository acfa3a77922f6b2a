#pragma once

#include <span>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"

namespace wirepack {

// Result files are changed in memory and put in place as a whole: HDF5 itself never writes to the
// disk, so a full disk cannot leave it with a file it can neither finish nor close.

/// A new, empty HDF5 file in memory. Files that are open at the same time must have different
/// names, or HDF5 takes them for the same; and nothing on the disk may have such a name.
Hdf5Handle create_image(const std::string& name);
/// A writable copy in memory of an HDF5 file given as its bytes.
Hdf5Handle open_image(std::vector<char>& bytes, const std::string& name);
/// The bytes of a file in memory, until it is changed or closed.
std::span<const char> bytes_of_image(hid_t file);

}  // namespace wirepack
