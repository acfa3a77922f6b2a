# WIREPACK_LIBRARY_VERSIONS: what is linked, for --version and result files.
function(wirepack_version_from_header out header)
  set(numbers "")
  file(STRINGS "${header}" lines REGEX "^#[ \t]*define")
  foreach(name IN LISTS ARGN)
    foreach(line IN LISTS lines)
      if(line MATCHES "define[ \t]+${name}[ \t]+([0-9]+)")
        list(APPEND numbers ${CMAKE_MATCH_1})
        break()
      endif()
    endforeach()
  endforeach()
  list(JOIN numbers "." version)
  set(${out} "${version}" PARENT_SCOPE)
endfunction()

wirepack_version_from_header(wirepack_hdf5_version "${WIREPACK_hdf5_INCLUDE_DIR}/H5public.h"
  H5_VERS_MAJOR H5_VERS_MINOR H5_VERS_RELEASE)
wirepack_version_from_header(wirepack_metis_version "${WIREPACK_metis_INCLUDE_DIR}/metis.h"
  METIS_VER_MAJOR METIS_VER_MINOR METIS_VER_SUBMINOR)
set(wirepack_ceres "")
if(WIREPACK_FIT)
  set(wirepack_ceres "Ceres ${Ceres_VERSION}")
endif()
string(JOIN ", " WIREPACK_LIBRARY_VERSIONS
  "Eigen ${Eigen3_VERSION}" "NLopt ${NLopt_VERSION}" ${wirepack_ceres}
  "HDF5 ${wirepack_hdf5_version}" "METIS ${wirepack_metis_version}"
  "toml++ ${tomlplusplus_VERSION}" "fmt ${fmt_VERSION}")
