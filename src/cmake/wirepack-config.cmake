@PACKAGE_INIT@

include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(NLopt CONFIG)
find_dependency(fmt CONFIG)
find_dependency(tomlplusplus CONFIG)
find_dependency(ZLIB)
include("${CMAKE_CURRENT_LIST_DIR}/c_libraries.cmake")
if(wirepack_missing)
  set(wirepack_FOUND FALSE)
  set(wirepack_NOT_FOUND_MESSAGE "${wirepack_missing}")
  return()
endif()

include("${CMAKE_CURRENT_LIST_DIR}/wirepack-targets.cmake")
# find_package(wirepack COMPONENTS fit): wirepack::fit, shapes from measured points, which brings
# Ceres
if("fit" IN_LIST wirepack_FIND_COMPONENTS AND
   EXISTS "${CMAKE_CURRENT_LIST_DIR}/wirepack-fit-targets.cmake")
  find_dependency(Ceres 2.1 CONFIG)
  include("${CMAKE_CURRENT_LIST_DIR}/wirepack-fit-targets.cmake")
  set(wirepack_fit_FOUND TRUE)
endif()
check_required_components(wirepack)
