# SPDX-License-Identifier: Apache-2.0
# What a user can choose, and the flags that hold for the whole tree.

option(LUME_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(LUME_BUILD_BENCHMARKS "Build the benchmarks, which need Google Benchmark" OFF)
option(LUME_BUILD_FUZZERS "Build the fuzzers, which need clang++" OFF)
option(LUME_NATIVE "Compile for this very machine instead of x86-64-v2" OFF)
option(LUME_STD_THREADS "Parallel loops on std::thread instead of oneTBB, for ThreadSanitizer" OFF)
option(LUME_WERROR "Treat warnings as errors" OFF)
set(LUME_SANITIZE "" CACHE STRING "Sanitizers: address,undefined or thread or nothing")

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release (-O3 -DNDEBUG) unless said otherwise" FORCE)
  endif()
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
endif()

if(LUME_SANITIZE)
  # The whole tree or nothing: a sanitizer sees only what it instruments.
  add_compile_options(-fsanitize=${LUME_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${LUME_SANITIZE})
endif()

# For what is not on the path of a ray, tests and the command line: instrumented code takes the compiler
# twice as long when it is optimised at all.
if(LUME_SANITIZE)
  set(LUME_QUICKLY_COMPILED -O0)
else()
  set(LUME_QUICKLY_COMPILED -O1)
endif()

# ccache understands precompiled headers only when told so (ccache manual, "Precompiled headers").
find_program(LUME_CCACHE ccache)
mark_as_advanced(LUME_CCACHE)
if(PROJECT_IS_TOP_LEVEL AND LUME_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime
      ${LUME_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
  else()
    add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>")
  endif()
endif()
