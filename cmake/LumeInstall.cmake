# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` adds to the libraries, headers and program: the files of find_package(Lume).
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Lume)
configure_package_config_file(cmake/LumeConfig.cmake.in LumeConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(LumeConfigVersion.cmake COMPATIBILITY SameMinorVersion)

install(
  FILES ${PROJECT_BINARY_DIR}/LumeConfig.cmake ${PROJECT_BINARY_DIR}/LumeConfigVersion.cmake
        cmake/LumeDependencies.cmake
  DESTINATION ${package_dir})
install(
  EXPORT LumeTargets
  NAMESPACE lume::
  DESTINATION ${package_dir})
install(FILES ${PROJECT_BINARY_DIR}/generated/lume_version.h
              include/lume/accelerator_plugin.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lume)
