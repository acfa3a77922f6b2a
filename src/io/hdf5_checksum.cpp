#include "hdf5_checksum.hpp"

#include <cstdint>
#include <vector>
#include <zlib.h>

#include "hdf5_values.hpp"

namespace wirepack {

namespace {

constexpr const char* attribute_name = "checksum";

class Checksum {
 public:
  void add(const void* data, std::size_t size) {
    value_ = crc32_z(value_, static_cast<const unsigned char*>(data), size);
  }
  void add(const std::string& name) { add(name.c_str(), name.size() + 1); }
  std::int64_t value() const { return static_cast<std::int64_t>(value_); }

 private:
  uLong value_ = crc32_z(0, nullptr, 0);
};

herr_t note_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

std::vector<std::string> attributes_of(hid_t object) {
  std::vector<std::string> names;
  hdf5_checked(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_attribute, &names),
               "listing attributes");
  return names;
}

// The type in which values are read, whatever machine has written them.
hid_t memory_type(hid_t type) {
  switch (H5Tget_class(type)) {
    case H5T_FLOAT:
      return H5T_NATIVE_DOUBLE;
    case H5T_INTEGER:
      return H5Tget_sign(type) == H5T_SGN_NONE ? H5T_NATIVE_UINT64 : H5T_NATIVE_INT64;
    case H5T_STRING:
      return type;
    default:
      throw FileError("it has values of an unexpected type");
  }
}

std::vector<char> buffer_for(hid_t space, hid_t type) {
  const hssize_t count = hdf5_checked(H5Sget_simple_extent_npoints(space), "reading sizes");
  return std::vector<char>(static_cast<std::size_t>(count) * H5Tget_size(type));
}

void add_attributes(Checksum& sum, hid_t object) {
  for (const std::string& name : attributes_of(object)) {
    if (name == attribute_name) continue;
    const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, name);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, name);
    if (H5Tis_variable_str(type) > 0) continue;
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, name);
    std::vector<char> bytes = buffer_for(space, memory_type(type));
    hdf5_checked(H5Aread(attribute, memory_type(type), bytes.data()), "reading " + name);
    sum.add(name);
    sum.add(bytes.data(), bytes.size());
  }
}

void add_dataset(Checksum& sum, hid_t dataset, const std::string& name) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, name);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, name);
  std::vector<char> bytes = buffer_for(space, memory_type(type));
  if (bytes.empty()) return;
  hdf5_checked(H5Dread(dataset, memory_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
               "reading " + name);
  sum.add(bytes.data(), bytes.size());
}

// Deeper than any group of a result; a group can hold itself.
constexpr int most_levels = 4;

void add_group(Checksum& sum, hid_t group, int level) {
  if (level > most_levels) throw FileError("it has groups within groups within groups");
  add_attributes(sum, group);
  for (const std::string& name : links_of(group)) {
    sum.add(name);
    const Hdf5Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose, "opening " + name);
    if (H5Iget_type(object) == H5I_GROUP) {
      add_group(sum, object, level + 1);
    } else {
      add_attributes(sum, object);
      add_dataset(sum, object, name);
    }
  }
}

std::int64_t checksum_of(hid_t group) {
  Checksum sum;
  add_group(sum, group, 0);
  return sum.value();
}

}  // namespace

void write_checksum(hid_t group) { write_attribute(group, attribute_name, checksum_of(group)); }

void verify_checksum(hid_t group) {
  const auto kept = read_attribute<std::int64_t>(group, attribute_name);
  if (kept != checksum_of(group)) throw FileError("its checksum does not fit");
}

}  // namespace wirepack
