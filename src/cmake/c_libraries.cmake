# Target wirepack::hdf5 for a C library whose own package has no target that every project can use. For the build of wirepack and, installed, for projects that use it.
foreach(wirepack_entry "hdf5|hdf5 hdf5_serial|hdf5.h|hdf5/serial")
  string(REPLACE "|" ";" wirepack_entry "${wirepack_entry}")
  list(GET wirepack_entry 0 wirepack_name)
  list(GET wirepack_entry 1 wirepack_library_names)
  list(GET wirepack_entry 2 wirepack_header)
  list(GET wirepack_entry 3 wirepack_folder)
  string(REPLACE " " ";" wirepack_library_names "${wirepack_library_names}")
  find_library(WIREPACK_${wirepack_name}_LIBRARY NAMES ${wirepack_library_names}
    PATH_SUFFIXES ${wirepack_folder})
  find_path(WIREPACK_${wirepack_name}_INCLUDE_DIR ${wirepack_header}
    PATH_SUFFIXES ${wirepack_folder})
  mark_as_advanced(WIREPACK_${wirepack_name}_LIBRARY WIREPACK_${wirepack_name}_INCLUDE_DIR)
  if(NOT WIREPACK_${wirepack_name}_LIBRARY OR NOT WIREPACK_${wirepack_name}_INCLUDE_DIR)
    set(wirepack_missing "wirepack needs the library ${wirepack_name}, which was not found")
  elseif(NOT TARGET wirepack::${wirepack_name})
    add_library(wirepack::${wirepack_name} UNKNOWN IMPORTED)
    set_target_properties(wirepack::${wirepack_name} PROPERTIES
      IMPORTED_LOCATION "${WIREPACK_${wirepack_name}_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${WIREPACK_${wirepack_name}_INCLUDE_DIR}")
  endif()
endforeach()
