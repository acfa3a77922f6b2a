#include "hdf5_image.hpp"

namespace wirepack {

namespace {

constexpr std::size_t growth = std::size_t{1} << 20;

Hdf5Handle memory_access() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "preparing memory");
  hdf5_checked(H5Pset_fapl_core(access, growth, false), "preparing memory");
  return access;
}

// From the format of 1.8 on the headers of groups and datasets have checksums: damage is noticed
// before it is believed. The file as a whole stays in the oldest format, as H5Fget_file_image
// spoils the checksum of newer superblocks (mended in HDF5 2.0).
Hdf5Handle with_checksums(Hdf5Handle file) {
  hdf5_checked(H5Fset_libver_bounds(file, H5F_LIBVER_V18, H5F_LIBVER_V18), "preparing the file");
  return file;
}

}  // namespace

Hdf5Handle create_image(const std::string& name) {
  const Hdf5Handle properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "creating the file");
  hdf5_checked(H5Pset_obj_track_times(properties, false), "creating the file");
  return with_checksums({H5Fcreate(name.c_str(), H5F_ACC_TRUNC, properties, memory_access()),
                         H5Fclose, "creating the file"});
}

Hdf5Handle open_image(std::vector<char>& bytes, const std::string& name) {
  const Hdf5Handle access = memory_access();
  hdf5_checked(H5Pset_file_image(access, bytes.data(), bytes.size()), "loading the file");
  return with_checksums(
      {H5Fopen(name.c_str(), H5F_ACC_RDWR, access), H5Fclose, "opening the file"});
}

std::span<const char> bytes_of_image(hid_t file) {
  hdf5_checked(H5Fflush(file, H5F_SCOPE_GLOBAL), "finishing the file");
  const ssize_t size = hdf5_checked(H5Fget_file_image(file, nullptr, 0), "finishing the file");
  // A file in memory has a place in memory as its handle.
  void* place = nullptr;
  hdf5_checked(H5Fget_vfd_handle(file, H5P_DEFAULT, &place), "finishing the file");
  return {*static_cast<char**>(place), static_cast<std::size_t>(size)};
}

}  // namespace wirepack
