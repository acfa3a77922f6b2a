#pragma once

#include "hdf5_handle.hpp"

namespace wirepack {

/// Throws FileError unless all of a file is in the file itself and of a size that it can have: its
/// links are hard, its datasets neither external nor virtual, chunked as wirepack does it, without
/// other filters than checksums, shuffling and deflation. Reading such a file touches no other one,
/// and takes no more memory than the file has bytes.
void check_safety(hid_t file);

}  // namespace wirepack
