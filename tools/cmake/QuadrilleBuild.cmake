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

# Warnings, and one rounding per operation so that results compare bit by bit.
function(quadrille_settings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -ffp-contract=off
                         $<$<BOOL:${QUADRILLE_WERROR}>:-Werror>)
endfunction()
