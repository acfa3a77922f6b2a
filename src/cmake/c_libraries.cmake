# Targets wirepack::hdf5, wirepack::metis and wirepack::zip, as the libraries' own packages have
# none that every project can use. For the build of wirepack and, installed, for projects that
# use it.
function(wirepack_c_library name header)
  cmake_parse_arguments(PARSE_ARGV 2 search "" "" "NAMES;PATH_SUFFIXES")
  find_library(WIREPACK_${name}_LIBRARY NAMES ${search_NAMES} PATH_SUFFIXES ${search_PATH_SUFFIXES})
  find_path(WIREPACK_${name}_INCLUDE_DIR ${header} PATH_SUFFIXES ${search_PATH_SUFFIXES})
  mark_as_advanced(WIREPACK_${name}_LIBRARY WIREPACK_${name}_INCLUDE_DIR)
  if(NOT WIREPACK_${name}_LIBRARY OR NOT WIREPACK_${name}_INCLUDE_DIR)
    set(wirepack_missing "wirepack needs the library ${name}, which was not found" PARENT_SCOPE)
  elseif(NOT TARGET wirepack::${name})
    add_library(wirepack::${name} UNKNOWN IMPORTED)
    set_target_properties(wirepack::${name} PROPERTIES
      IMPORTED_LOCATION "${WIREPACK_${name}_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${WIREPACK_${name}_INCLUDE_DIR}")
  endif()
endfunction()

wirepack_c_library(hdf5 hdf5.h NAMES hdf5 hdf5_serial PATH_SUFFIXES hdf5/serial)
wirepack_c_library(metis metis.h NAMES metis)
wirepack_c_library(zip zip.h NAMES zip)
