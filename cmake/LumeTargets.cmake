# SPDX-License-Identifier: Apache-2.0
# How every target of Lume is compiled.

# The baseline every 64-bit machine since about 2009 has. Fused multiply-adds are off so that pixels
# do not depend on the instruction set; nobody here reads errno after a square root.
add_library(lume_flags INTERFACE)
target_compile_features(lume_flags INTERFACE cxx_std_20)
target_compile_options(
  lume_flags
  INTERFACE $<IF:$<BOOL:${LUME_NATIVE}>,-march=native,-march=x86-64-v2>
            -ffp-contract=off
            -fno-math-errno
            -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            # clang++ counts it to -Wconversion, g++ does not
            -Wno-sign-conversion
            -Wnon-virtual-dtor
            -Woverloaded-virtual
            -Wcast-qual
            # g++ 12 sees overlaps in std::string's own code (GCC bug 105651)
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
            $<$<BOOL:${LUME_WERROR}>:-Werror>)

# lume_add_library(<folder>): the static library lume_<folder>, known as lume::<folder>, with its
# headers included from the project's root as "<folder>/name.h".
function(lume_add_library folder)
  set(target lume_${folder})
  add_library(${target} STATIC)
  add_library(lume::${folder} ALIAS ${target})
  target_include_directories(
    ${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/lume>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:lume_flags>)
  set_target_properties(
    ${target}
    PROPERTIES CXX_EXTENSIONS OFF
               EXPORT_NAME ${folder}
               LINKER_LANGUAGE CXX
               POSITION_INDEPENDENT_CODE ON)
  install(TARGETS ${target} EXPORT LumeTargets DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(
    DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lume/${folder}
    FILES_MATCHING
    PATTERN "*.h"
    PATTERN "cli" EXCLUDE)
endfunction()

# lume_add_executable(<name>): a program compiled as the libraries are.
function(lume_add_executable name)
  add_executable(${name})
  target_link_libraries(${name} PRIVATE lume_flags)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
endfunction()

# lume_precompile(<target> <header>...): these and what all files include are compiled once. What a
# file needs it still includes itself; the tidy preset builds without and finds what is missing.
function(lume_precompile target)
  target_precompile_headers(
    ${target}
    PRIVATE
    <algorithm>
    <array>
    <cmath>
    <cstdint>
    <functional>
    <limits>
    <memory>
    <optional>
    <span>
    <string>
    <variant>
    <vector>
    <glm/glm.hpp>
    <glm/gtc/quaternion.hpp>
    ${ARGN})
endfunction()
