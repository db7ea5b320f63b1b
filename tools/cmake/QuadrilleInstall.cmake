# Installs the libraries with their headers, for find_package(quadrille CONFIG) and pkg-config.
include(CMakePackageConfigHelpers)

set(QUADRILLE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/quadrille)
set(QUADRILLE_PKGCONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH QUADRILLE_PREFIX_FROM_PKGCONFIG
     ${CMAKE_INSTALL_PREFIX}/${QUADRILLE_PKGCONFIG_DIR} ${CMAKE_INSTALL_PREFIX})

# quadrille_install_library(COMPONENT DESCRIPTION REQUIRES LIBS): installs quadrille::COMPONENT.
# REQUIRES are pkg-config modules, LIBS further linker flags.
function(quadrille_install_library component description requires libs)
  install(TARGETS quadrille_${component} EXPORT quadrille_${component}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT quadrille_${component} NAMESPACE quadrille::
          FILE quadrille_${component}.cmake DESTINATION ${QUADRILLE_CMAKE_DIR})
  set(module quadrille-${component})
  set(library "-lquadrille_${component} ")
  get_target_property(type quadrille_${component} TYPE)
  if(type STREQUAL INTERFACE_LIBRARY)
    set(library "")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/quadrille.pc.in
                 ${PROJECT_BINARY_DIR}/${module}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${module}.pc DESTINATION ${QUADRILLE_PKGCONFIG_DIR})
endfunction()

# fcl.pc sets -std=c++11 and lcm.pc asks for glib, so neither is a "Requires".
quadrille_install_library(detector "Detection of quadrics in point clouds" "eigen3" "-pthread")
quadrille_install_library(grasping "Grasp planning on quadrics" "quadrille-detector"
                          "-lfcl -lccd -loctomap -loctomath")
quadrille_install_library(lcmtypes "LCM messages of quadrille" "" "-llcm")
quadrille_install_library(bus "Checked decoding and connections for LCM"
                          "quadrille-lcmtypes quadrille-detector" "")

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/tools/cmake/quadrilleConfig.cmake.in
  ${PROJECT_BINARY_DIR}/quadrilleConfig.cmake INSTALL_DESTINATION ${QUADRILLE_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/quadrilleConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/quadrilleConfig.cmake
              ${PROJECT_BINARY_DIR}/quadrilleConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/tools/cmake/FindLcm.cmake
        DESTINATION ${QUADRILLE_CMAKE_DIR})

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Units of systemd, for those who want them: systemctl link or enable them after the installation.
foreach(unit quadrille-detector quadrille-grasp-planner)
  configure_file(${PROJECT_SOURCE_DIR}/tools/packaging/systemd/${unit}.service.in
                 ${PROJECT_BINARY_DIR}/${unit}.service @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${unit}.service DESTINATION lib/systemd/system)
endforeach()
