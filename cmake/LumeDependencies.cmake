# SPDX-License-Identifier: Apache-2.0
# Every library that Lume links, for its own build and, installed beside LumeConfig.cmake, for the
# projects that use it.

find_package(glm REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(TBB 2021.8 REQUIRED)
find_package(Threads REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(pugixml REQUIRED)
find_package(draco 1.5 REQUIRED)
find_package(meshoptimizer 0.18 REQUIRED)

# Debian's CMake files of OpenImageIO and OpenColorIO do not work: the first insists on programs and an
# opencv that are in other packages, the second stands where find_package does not look and names
# libraries that are not there. Their pkg-config files are right; libwebp and libxxhash
# have no others; that of toml++ says that the library is compiled.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OIIO REQUIRED QUIET IMPORTED_TARGET GLOBAL OpenImageIO>=2.4)
pkg_check_modules(OCIO REQUIRED QUIET IMPORTED_TARGET GLOBAL OpenColorIO>=2.1)
pkg_check_modules(WEBP REQUIRED QUIET IMPORTED_TARGET GLOBAL libwebp)
pkg_check_modules(XXHASH REQUIRED QUIET IMPORTED_TARGET GLOBAL libxxhash)
pkg_check_modules(TOMLPLUSPLUS REQUIRED QUIET IMPORTED_TARGET GLOBAL tomlplusplus>=3.3)
