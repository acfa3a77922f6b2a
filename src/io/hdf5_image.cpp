#include "hdf5_image.hpp"

namespace wirepack {

namespace {

constexpr std::size_t growth = std::size_t{1} << 20;

// HDF5 wants names, but never looks them up: nothing of these names is made on the disk. Two open files
// of one name would be the same to it.
constexpr const char* new_in_memory = "wirepack-new-result-in-memory";
constexpr const char* old_in_memory = "wirepack-old-result-in-memory";

Hdf5Handle memory_access() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "preparing memory");
  hdf5_checked(H5Pset_fapl_core(access, growth, false), "preparing memory");
  return access;
}

// From the format of 1.8 on the headers of groups and datasets have checksums: damage is noticed
// before it is believed. The file as a whole stays in the oldest format, as H5Fget_file_image spoils
// the checksum of newer superblocks (mended in HDF5 2.0).
Hdf5Handle with_checksums(Hdf5Handle file) {
  hdf5_checked(H5Fset_libver_bounds(file, H5F_LIBVER_V18, H5F_LIBVER_V18), "preparing the file");
  return file;
}

}  // namespace

Hdf5Handle create_image() {
  const Hdf5Handle properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "creating the file");
  hdf5_checked(H5Pset_obj_track_times(properties, false), "creating the file");
  return with_checksums({H5Fcreate(new_in_memory, H5F_ACC_TRUNC, properties, memory_access()),
                         H5Fclose, "creating the file"});
}

Hdf5Handle open_image(std::vector<char>& bytes) {
  const Hdf5Handle access = memory_access();
  hdf5_checked(H5Pset_file_image(access, bytes.data(), bytes.size()), "loading the file");
  return with_checksums(
      {H5Fopen(old_in_memory, H5F_ACC_RDWR, access), H5Fclose, "opening the file"});
}

std::vector<char> bytes_of_image(hid_t file) {
  hdf5_checked(H5Fflush(file, H5F_SCOPE_GLOBAL), "finishing the file");
  const ssize_t size = hdf5_checked(H5Fget_file_image(file, nullptr, 0), "finishing the file");
  std::vector<char> bytes(static_cast<std::size_t>(size));
  hdf5_checked(H5Fget_file_image(file, bytes.data(), bytes.size()), "finishing the file");
  return bytes;
}

}  // namespace wirepack
