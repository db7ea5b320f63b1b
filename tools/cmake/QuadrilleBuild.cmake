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

include(GNUInstallDirs)

set(QUADRILLE_SANITIZE "" CACHE STRING "Sanitizers for all targets, such as address,undefined")
if(QUADRILLE_SANITIZE)
  add_compile_options(-fsanitize=${QUADRILLE_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${QUADRILLE_SANITIZE})
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
