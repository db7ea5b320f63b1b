# Finds LCM with or without its own CMake package (1.3 has none, and its
# pkg-config file asks for glib, which neither its headers nor we need).
#
# Defines the imported target Lcm::lcm and the variable LCM_GEN.
find_package(lcm CONFIG QUIET)
if(lcm_FOUND AND TARGET lcm)
  if(NOT TARGET Lcm::lcm)
    add_library(Lcm::lcm INTERFACE IMPORTED)
    set_target_properties(Lcm::lcm PROPERTIES INTERFACE_LINK_LIBRARIES lcm)
  endif()
  set(LCM_LIBRARY lcm)
  set(LCM_INCLUDE_DIR lcm)
else()
  find_path(LCM_INCLUDE_DIR lcm/lcm-cpp.hpp)
  find_library(LCM_LIBRARY lcm)
  if(LCM_INCLUDE_DIR AND LCM_LIBRARY AND NOT TARGET Lcm::lcm)
    add_library(Lcm::lcm UNKNOWN IMPORTED)
    set_target_properties(Lcm::lcm PROPERTIES
      IMPORTED_LOCATION ${LCM_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${LCM_INCLUDE_DIR})
  endif()
endif()
find_program(LCM_GEN lcm-gen)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Lcm REQUIRED_VARS LCM_LIBRARY LCM_INCLUDE_DIR LCM_GEN)
mark_as_advanced(LCM_INCLUDE_DIR LCM_LIBRARY LCM_GEN)
