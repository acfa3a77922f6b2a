# Target wirepack::hdf5, as HDF5's own package has no target that every project can use. For the build
# of wirepack and, installed, for projects that use it.
find_library(WIREPACK_hdf5_LIBRARY NAMES hdf5 hdf5_serial PATH_SUFFIXES hdf5/serial)
find_path(WIREPACK_hdf5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
mark_as_advanced(WIREPACK_hdf5_LIBRARY WIREPACK_hdf5_INCLUDE_DIR)
if(NOT WIREPACK_hdf5_LIBRARY OR NOT WIREPACK_hdf5_INCLUDE_DIR)
  set(wirepack_missing "wirepack needs the library hdf5, which was not found")
elseif(NOT TARGET wirepack::hdf5)
  add_library(wirepack::hdf5 UNKNOWN IMPORTED)
  set_target_properties(wirepack::hdf5 PROPERTIES
    IMPORTED_LOCATION "${WIREPACK_hdf5_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${WIREPACK_hdf5_INCLUDE_DIR}")
endif()
