#include "hdf5_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace wirepack {

namespace {

constexpr hsize_t rows_per_chunk = 256;

Hdf5Handle creation_properties(hid_t kind) {
  Hdf5Handle properties(H5Pcreate(kind), H5Pclose, "preparing a dataset");
  // equal runs must give equal files
  hdf5_checked(H5Pset_obj_track_times(properties, false), "preparing a dataset");
  return properties;
}

void set_chunks(hid_t properties, int rank, const hsize_t* chunk, const std::string& name) {
  hdf5_checked(H5Pset_chunk(properties, rank, chunk), "creating " + name);
  hdf5_checked(H5Pset_fletcher32(properties), "creating " + name);
}

Hdf5Handle open_dataset(hid_t location, const std::string& name) {
  return {H5Dopen2(location, name.c_str(), H5P_DEFAULT), H5Dclose, "opening " + name};
}

Hdf5Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose, "preparing an attribute"}; }

Hdf5Handle text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "preparing a text");
  hdf5_checked(H5Tset_size(type, H5T_VARIABLE), "preparing a text");
  hdf5_checked(H5Tset_cset(type, H5T_CSET_UTF8), "preparing a text");
  return type;
}

Hdf5Handle open_attribute(hid_t location, const std::string& name, hid_t type) {
  if (has_attribute(location, name)) {
    return {H5Aopen(location, name.c_str(), H5P_DEFAULT), H5Aclose, "opening attribute " + name};
  }
  return {H5Acreate2(location, name.c_str(), type, scalar_space(), H5P_DEFAULT, H5P_DEFAULT),
          H5Aclose, "creating attribute " + name};
}

template <class T>
Hdf5Handle create_growing(hid_t location, const std::string& name, hsize_t columns) {
  const std::array<hsize_t, 2> size{0, columns}, chunk{rows_per_chunk, columns},
      most{H5S_UNLIMITED, columns};
  const int rank = columns > 0 ? 2 : 1;
  const Hdf5Handle space(H5Screate_simple(rank, size.data(), most.data()), H5Sclose,
                         "creating " + name);
  const Hdf5Handle properties = creation_properties(H5P_DATASET_CREATE);
  set_chunks(properties, rank, chunk.data(), name);
  return {H5Dcreate2(location, name.c_str(), hdf5_file_type<T>(), space, H5P_DEFAULT, properties,
                     H5P_DEFAULT),
          H5Dclose, "creating " + name};
}

}  // namespace

template <>
hid_t hdf5_memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t hdf5_memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t hdf5_memory_type<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}
template <>
hid_t hdf5_file_type<double>() {
  return H5T_IEEE_F64LE;
}
template <>
hid_t hdf5_file_type<std::int64_t>() {
  return H5T_STD_I64LE;
}
template <>
hid_t hdf5_file_type<std::uint64_t>() {
  return H5T_STD_U64LE;
}

bool has_link(hid_t location, const std::string& name) {
  return hdf5_checked(H5Lexists(location, name.c_str(), H5P_DEFAULT), "looking for " + name) > 0;
}

namespace {

herr_t note_link(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

std::vector<std::string> links_of(hid_t group) {
  std::vector<std::string> names;
  hdf5_checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_link, &names),
               "listing a group");
  return names;
}

void remove_link(hid_t location, const std::string& name) {
  hdf5_checked(H5Ldelete(location, name.c_str(), H5P_DEFAULT), "replacing " + name);
}

Hdf5Handle open_group(hid_t location, const std::string& name) {
  return {H5Gopen2(location, name.c_str(), H5P_DEFAULT), H5Gclose, "opening " + name};
}

bool has_attribute(hid_t location, const std::string& name) {
  return hdf5_checked(H5Aexists(location, name.c_str()), "looking for attribute " + name) > 0;
}

Hdf5Handle open_or_create_group(hid_t location, const std::string& name) {
  if (has_link(location, name)) return open_group(location, name);
  return {H5Gcreate2(location, name.c_str(), H5P_DEFAULT, creation_properties(H5P_GROUP_CREATE),
                     H5P_DEFAULT),
          H5Gclose, "creating " + name};
}

namespace {

hsize_t size_of_file(hid_t location) {
  hsize_t size = 0;
  const Hdf5Handle file(H5Iget_file_id(location), H5Fclose, "reading a file");
  hdf5_checked(H5Fget_filesize(file, &size), "reading a file");
  return size;
}

Hdf5Handle fixed_text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "preparing a text");
  hdf5_checked(H5Tset_size(type, std::max<std::size_t>(size, 1)), "preparing a text");
  hdf5_checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "preparing a text");
  hdf5_checked(H5Tset_cset(type, H5T_CSET_UTF8), "preparing a text");
  return type;
}

// Squares and products of what a run has are far below.
constexpr double largest_number = 1e100;

void check_number(double value, const std::string& name) {
  if (!(std::abs(value) <= largest_number)) {
    throw FileError(name + " has a number that no run can have");
  }
}
void check_number(std::int64_t, const std::string&) {}
void check_number(std::uint64_t, const std::string&) {}

}  // namespace

template <class T>
void write_attribute(hid_t location, const std::string& name, T value) {
  const Hdf5Handle attribute = open_attribute(location, name, hdf5_file_type<T>());
  hdf5_checked(H5Awrite(attribute, hdf5_memory_type<T>(), &value), "writing attribute " + name);
}

void write_attribute(hid_t location, const std::string& name, const std::string& value) {
  // The text itself lies in a heap that only grows, so an equal text is left alone.
  if (H5Aexists(location, name.c_str()) > 0 && read_text_attribute(location, name) == value) return;
  const Hdf5Handle attribute = open_attribute(location, name, text_type());
  const char* text = value.c_str();
  hdf5_checked(H5Awrite(attribute, text_type(), &text), "writing attribute " + name);
}

template <class T>
T read_attribute(hid_t location, const std::string& name) {
  const Hdf5Handle attribute(H5Aopen(location, name.c_str(), H5P_DEFAULT), H5Aclose,
                             "opening attribute " + name);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, "reading attribute " + name);
  T value{};
  if (H5Sget_simple_extent_npoints(space) != 1) {
    throw FileError("reading attribute " + name + " failed");
  }
  hdf5_checked(H5Aread(attribute, hdf5_memory_type<T>(), &value), "reading attribute " + name);
  check_number(value, "attribute " + name);
  return value;
}

void write_fixed_text(hid_t location, const std::string& name, const std::string& value) {
  if (has_attribute(location, name)) {
    if (read_fixed_text(location, name) == value) return;
    hdf5_checked(H5Adelete(location, name.c_str()), "replacing attribute " + name);
  }
  const Hdf5Handle type = fixed_text_type(value.size());
  const Hdf5Handle attribute = open_attribute(location, name, type);
  hdf5_checked(H5Awrite(attribute, type, value.c_str()), "writing attribute " + name);
}

std::string read_fixed_text(hid_t location, const std::string& name) {
  const std::string what = "reading attribute " + name;
  const Hdf5Handle attribute(H5Aopen(location, name.c_str(), H5P_DEFAULT), H5Aclose, what);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, what);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, what);
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 ||
      H5Sget_simple_extent_npoints(space) != 1 || size > size_of_file(location)) {
    throw FileError(what + " failed");
  }
  std::string text(size, '\0');
  hdf5_checked(H5Aread(attribute, fixed_text_type(size), text.data()), what);
  return text.substr(0, text.find('\0'));
}

std::string read_text_attribute(hid_t location, const std::string& name) {
  const std::string what = "reading attribute " + name;
  const Hdf5Handle attribute(H5Aopen(location, name.c_str(), H5P_DEFAULT), H5Aclose, what);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, what);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, what);
  if (H5Tis_variable_str(type) <= 0 || H5Sget_simple_extent_npoints(space) != 1) {
    throw FileError(what + " failed");
  }
  char* text = nullptr;
  hdf5_checked(H5Aread(attribute, text_type(), &text), what);
  const std::unique_ptr<char, herr_t (*)(void*)> owner(text, H5free_memory);
  return text != nullptr ? std::string(text) : std::string();
}

template <class T>
void write_table(hid_t location, const std::string& name, const Hdf5Table<T>& table) {
  const std::array<hsize_t, 2> size{table.rows, table.columns};
  const int rank = table.columns > 0 ? 2 : 1;
  const Hdf5Handle space(H5Screate_simple(rank, size.data(), nullptr), H5Sclose,
                         "creating " + name);
  const Hdf5Handle properties = creation_properties(H5P_DATASET_CREATE);
  if (table.rows > 0) set_chunks(properties, rank, size.data(), name);
  const Hdf5Handle dataset(H5Dcreate2(location, name.c_str(), hdf5_file_type<T>(), space,
                                      H5P_DEFAULT, properties, H5P_DEFAULT),
                           H5Dclose, "creating " + name);
  if (table.values.empty()) return;
  hdf5_checked(
      H5Dwrite(dataset, hdf5_memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()),
      "writing " + name);
}

template <class T>
void replace_table(hid_t location, const std::string& name, const Hdf5Table<T>& table) {
  const Hdf5Handle dataset = has_link(location, name)
                                 ? open_dataset(location, name)
                                 : create_growing<T>(location, name, table.columns);
  const std::array<hsize_t, 2> size{table.rows, table.columns};
  hdf5_checked(H5Dset_extent(dataset, size.data()), "resizing " + name);
  if (table.values.empty()) return;
  hdf5_checked(
      H5Dwrite(dataset, hdf5_memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()),
      "writing " + name);
}

template <class T>
void append_values(hid_t location, const std::string& name, const std::vector<T>& values) {
  const Hdf5Handle dataset = has_link(location, name) ? open_dataset(location, name)
                                                      : create_growing<T>(location, name, 0);
  if (values.empty()) return;
  hsize_t before = 0;
  {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "resizing " + name);
    if (hdf5_checked(H5Sget_simple_extent_ndims(space), "resizing " + name) != 1) {
      throw FileError(name + " is not a list");
    }
    hdf5_checked(H5Sget_simple_extent_dims(space, &before, nullptr), "resizing " + name);
  }
  const hsize_t added = values.size(), after = before + added;
  hdf5_checked(H5Dset_extent(dataset, &after), "resizing " + name);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "writing " + name);
  hdf5_checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, &before, nullptr, &added, nullptr),
               "writing " + name);
  const Hdf5Handle memory(H5Screate_simple(1, &added, nullptr), H5Sclose, "writing " + name);
  hdf5_checked(H5Dwrite(dataset, hdf5_memory_type<T>(), memory, space, H5P_DEFAULT, values.data()),
               "writing " + name);
}

template <class T>
Hdf5Table<T> read_table(hid_t location, const std::string& name, hsize_t columns) {
  const Hdf5Handle dataset = open_dataset(location, name);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "reading " + name);
  std::array<hsize_t, 2> size{0, 0};
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank != (columns > 0 ? 2 : 1)) throw FileError(name + " has an unexpected shape");
  hdf5_checked(H5Sget_simple_extent_dims(space, size.data(), nullptr), "reading " + name);
  if (size[1] != columns) throw FileError(name + " has an unexpected shape");
  Hdf5Table<T> table;
  table.rows = size[0];
  table.columns = columns;
  // A damaged header can announce any size; what is not in the file cannot be read anyway.
  const hsize_t width = std::max<hsize_t>(1, columns);
  if (table.rows > size_of_file(location) / (sizeof(T) * width)) {
    throw FileError(name + " has an unexpected shape");
  }
  table.values.resize(table.rows * width);
  if (table.values.empty()) return table;
  hdf5_checked(
      H5Dread(dataset, hdf5_memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()),
      "reading " + name);
  for (const T value : table.values) check_number(value, name);
  return table;
}

template void write_attribute(hid_t, const std::string&, double);
template void write_attribute(hid_t, const std::string&, std::int64_t);
template void write_attribute(hid_t, const std::string&, std::uint64_t);
template double read_attribute(hid_t, const std::string&);
template std::int64_t read_attribute(hid_t, const std::string&);
template std::uint64_t read_attribute(hid_t, const std::string&);
template void write_table(hid_t, const std::string&, const Hdf5Table<double>&);
template void write_table(hid_t, const std::string&, const Hdf5Table<std::int64_t>&);
template void replace_table(hid_t, const std::string&, const Hdf5Table<double>&);
template void append_values(hid_t, const std::string&, const std::vector<double>&);
template void append_values(hid_t, const std::string&, const std::vector<std::int64_t>&);
template Hdf5Table<double> read_table(hid_t, const std::string&, hsize_t);
template Hdf5Table<std::int64_t> read_table(hid_t, const std::string&, hsize_t);

}  // namespace wirepack
