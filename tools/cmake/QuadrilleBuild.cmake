# Settings that all targets share.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
# Seen from outside is only what the public headers mark with QUADRILLE_EXPORT.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

# The same layout and allocation of Eigen's matrices whatever -march says; eigen_layout.hpp asks
# consumers for it.
add_compile_definitions(EIGEN_MAX_ALIGN_BYTES=16 EIGEN_MALLOC_ALREADY_ALIGNED=1)

include(GNUInstallDirs)
# Of the components runtime, dev, python and doc packages are made.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)
# What is installed is built by the target quadrille_installed, without the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

option(BUILD_SHARED_LIBS "Build shared libraries instead of static ones" OFF)
if(BUILD_SHARED_LIBS)
  # From bin and from the Python package in lib/python3/dist-packages.
  set(CMAKE_INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR} $ORIGIN/../../..)
endif()

set(QUADRILLE_SANITIZE "" CACHE STRING "Sanitizers for all targets, such as address,undefined")
if(QUADRILLE_SANITIZE)
  add_compile_options(-fsanitize=${QUADRILLE_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${QUADRILLE_SANITIZE})
endif()
option(QUADRILLE_COVERAGE "Count which lines run, as clang does; tools/coverage sums them up" OFF)
if(QUADRILLE_COVERAGE)
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
endif()

option(QUADRILLE_HARDENING "Harden as Debian does its packages, with the standard library's own checks" ON)
if(QUADRILLE_HARDENING AND NOT QUADRILLE_SANITIZE)
  # Two percent of the time of a detection, and no bit of a result.
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_compile_options(-fstack-protector-strong
                      "$<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
  add_link_options(-Wl,-z,relro,-z,now)
endif()

# GCC 12 sees these three where it has inlined the standard library's or Eigen's loops; they stay
# warnings.
set(QUADRILLE_WARNINGS -Wall -Wextra)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # Where && would keep a loop from becoming vector instructions.
  list(APPEND QUADRILLE_WARNINGS -Wno-bitwise-instead-of-logical)
endif()
if(QUADRILLE_WERROR)
  list(APPEND QUADRILLE_WARNINGS -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND QUADRILLE_WARNINGS -Wno-error=array-bounds -Wno-error=maybe-uninitialized
                -Wno-error=restrict)
  endif()
endif()

# Warnings, and one rounding per operation so that results compare bit by bit. Nobody reads errno
# after a square root; without it, loops of them become vector instructions.
function(quadrille_settings target)
  target_compile_options(${target} PRIVATE ${QUADRILLE_WARNINGS} -ffp-contract=off -fno-math-errno)
endfunction()

# quadrille_inside(NAME COMPONENT): all of quadrille::COMPONENT, with what a shared library hides, for
# those that look inside: fits, tests, experiments. Not installed.
function(quadrille_inside name component)
  if(BUILD_SHARED_LIBS)
    add_library(${name} STATIC $<TARGET_OBJECTS:quadrille_${component}>)
    set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  else()
    add_library(${name} INTERFACE)
  endif()
  target_include_directories(${name} INTERFACE src)
  target_link_libraries(${name} INTERFACE quadrille::${component})
endfunction()
