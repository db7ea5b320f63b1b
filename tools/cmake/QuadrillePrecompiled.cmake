# Headers of others that most sources include, compiled once and shared: half of a cold build is
# reading them. Sources still include what they use; -DQUADRILLE_PRECOMPILE=OFF builds without.
option(QUADRILLE_PRECOMPILE "Precompile the headers of Eigen, Catch2 and nlohmann-json" ON)
if(QUADRILLE_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # So that ccache knows sources that come with a precompiled header.
  add_compile_options(-fpch-preprocess)
endif()

set(QUADRILLE_PRECOMPILED_SOURCE ${PROJECT_SOURCE_DIR}/tools/cmake/precompiled.cpp)
set(QUADRILLE_PRECOMPILED_EIGEN
    <Eigen/Cholesky> <Eigen/Eigenvalues> <Eigen/Geometry> <Eigen/QR> <Eigen/SVD> <algorithm> <array>
    <cmath> <cstdint> <functional> <limits> <map> <memory> <numbers> <optional> <set> <span>
    <stdexcept> <string> <string_view> <utility> <vector>)

# quadrille_precompiled(NAME LIBRARY… HEADERS HEADER… [OPTIONS OPTION…]): a precompiled header that
# other targets may share; LIBRARY says where its headers are, OPTIONS how all of them are compiled.
function(quadrille_precompiled name)
  if(NOT QUADRILLE_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "HEADERS;OPTIONS" ${ARGN})
  add_library(quadrille_precompiled_${name} OBJECT ${QUADRILLE_PRECOMPILED_SOURCE})
  target_link_libraries(quadrille_precompiled_${name} PRIVATE Threads::Threads ${ARG_UNPARSED_ARGUMENTS})
  target_precompile_headers(quadrille_precompiled_${name} PRIVATE ${ARG_HEADERS})
  target_compile_options(quadrille_precompiled_${name} PRIVATE ${ARG_OPTIONS})
  quadrille_settings(quadrille_precompiled_${name})
endfunction()

# quadrille_share_precompiled(NAME TARGET…): the targets begin with that precompiled header.
function(quadrille_share_precompiled name)
  if(NOT QUADRILLE_PRECOMPILE)
    return()
  endif()
  foreach(target ${ARGN})
    target_precompile_headers(${target} REUSE_FROM quadrille_precompiled_${name})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL EXECUTABLE)
      # Compiled as libraries are, -fPIC and not -fPIE, or the header would not fit.
      set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
      target_compile_options(${target} PRIVATE -fPIC)
    endif()
  endforeach()
endfunction()

quadrille_precompiled(eigen Eigen3::Eigen HEADERS ${QUADRILLE_PRECOMPILED_EIGEN})
quadrille_precompiled(json Eigen3::Eigen nlohmann_json::nlohmann_json
                      HEADERS ${QUADRILLE_PRECOMPILED_EIGEN} <nlohmann/json.hpp>)

# quadrille_compile_in_batches(SIZE TARGET…): compiles so many sources at once, which instantiates
# the templates that they share once. What sources have in anonymous namespaces must not clash.
option(QUADRILLE_BATCHES "Compile several sources of tests and commands at once" ON)
function(quadrille_compile_in_batches size)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ${QUADRILLE_BATCHES}
                                           UNITY_BUILD_BATCH_SIZE ${size})
endfunction()
