#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"

namespace wirepack {

/// Types in memory and in files: double, std::int64_t, std::uint64_t.
template <class T>
hid_t hdf5_memory_type();
template <class T>
hid_t hdf5_file_type();

/// A table of rows of equal length in row order; columns = 0 is a plain list.
template <class T>
struct Hdf5Table {
  std::vector<T> values;
  hsize_t rows = 0;
  hsize_t columns = 0;
};

/// Opens a group, or makes it where it is missing.
Hdf5Handle open_or_create_group(hid_t location, const std::string& name);
Hdf5Handle open_group(hid_t location, const std::string& name);
bool has_link(hid_t location, const std::string& name);
/// Names of what a group holds, in order.
std::vector<std::string> links_of(hid_t group);
void remove_link(hid_t location, const std::string& name);

/// Sets an attribute, new or not.
template <class T>
void write_attribute(hid_t location, const std::string& name, T value);
void write_attribute(hid_t location, const std::string& name, const std::string& value);
bool has_attribute(hid_t location, const std::string& name);
template <class T>
T read_attribute(hid_t location, const std::string& name);
std::string read_text_attribute(hid_t location, const std::string& name);

// Texts of variable length, as above, are what other readers take for texts; they lie in a heap
// without checksum, a damage of which HDF5 does not survive. Those of fixed length lie beside their
// name.
void write_fixed_text(hid_t location, const std::string& name, const std::string& value);
std::string read_fixed_text(hid_t location, const std::string& name);

// All data have checksums, so that a damaged file is noticed and not computed with.

/// A dataset that never changes.
template <class T>
void write_table(hid_t location, const std::string& name, const Hdf5Table<T>& table);
/// A dataset whose contents are replaced in place: a file that is flushed a thousand times must
/// not grow by a thousand dead copies, as HDF5 forgets freed space when a file is closed.
template <class T>
void replace_table(hid_t location, const std::string& name, const Hdf5Table<T>& table);
/// Appends to a plain list, which is made where it is missing.
template <class T>
void append_values(hid_t location, const std::string& name, const std::vector<T>& values);
/// Throws FileError unless it has `columns` columns (0: is a plain list).
/// Numbers beyond any that a run can have, and none at all (NaN), are a damage, too.
template <class T>
Hdf5Table<T> read_table(hid_t location, const std::string& name, hsize_t columns);

}  // namespace wirepack
