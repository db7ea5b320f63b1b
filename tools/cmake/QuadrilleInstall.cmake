# Installs the libraries with their headers, for find_package(quadrille CONFIG) and pkg-config.
include(CMakePackageConfigHelpers)

set(QUADRILLE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/quadrille)
set(QUADRILLE_PKGCONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH QUADRILLE_PREFIX_FROM_PKGCONFIG
     ${CMAKE_INSTALL_PREFIX}/${QUADRILLE_PKGCONFIG_DIR} ${CMAKE_INSTALL_PREFIX})

# quadrille_install_library(COMPONENT DESCRIPTION REQUIRES LIBS): installs quadrille::COMPONENT.
# REQUIRES are pkg-config modules, LIBS further linker flags.
function(quadrille_install_library component description requires libs)
  # Before 1.0 a new minor version may change the binary interface. Without a symbol that is defined
  # for shared libraries alone their objects are those of static ones.
  set_target_properties(quadrille_${component} PROPERTIES VERSION ${PROJECT_VERSION} DEFINE_SYMBOL ""
                        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(TARGETS quadrille_${component} EXPORT quadrille_${component}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_COMPONENT dev
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
  get_target_property(type quadrille_${component} TYPE)
  if(type STREQUAL STATIC_LIBRARY AND NOT QUADRILLE_SANITIZE AND NOT QUADRILLE_COVERAGE)
    install(CODE "execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/tools/packaging/seal_archive\"
                    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libquadrille_${component}.a\"
                    \"${CMAKE_LINKER}\" \"${CMAKE_OBJCOPY}\" \"${CMAKE_AR}\" \"${CMAKE_NM}\"
                    COMMAND_ERROR_IS_FATAL ANY)" COMPONENT dev)
  endif()
  install(EXPORT quadrille_${component} NAMESPACE quadrille:: COMPONENT dev
          FILE quadrille_${component}.cmake DESTINATION ${QUADRILLE_CMAKE_DIR})
  set(module quadrille-${component})
  set(library "-lquadrille_${component} ")
  if(type STREQUAL INTERFACE_LIBRARY)
    set(library "")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/quadrille.pc.in
                 ${PROJECT_BINARY_DIR}/${module}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${module}.pc DESTINATION ${QUADRILLE_PKGCONFIG_DIR}
          COMPONENT dev)
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
        DESTINATION ${QUADRILLE_CMAKE_DIR} COMPONENT dev)

# The message types for other languages, where LCM's tools look for them.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/lcmtypes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lcmtypes
        COMPONENT dev FILES_MATCHING PATTERN "*.lcm" PATTERN bus EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/grippers DESTINATION ${CMAKE_INSTALL_DATADIR}/quadrille)
# Those of C++ are built alone as the consumer projects show.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples COMPONENT dev
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libquadrille-dev PATTERN examples/CMakeLists.txt EXCLUDE)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)

# The pages with their pictures, in folders as here, which they link to.
set(pages)
foreach(folder . detector grasping lcmtypes tools examples)
  file(GLOB found RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${folder}/*.md ${folder}/*/*.md
       ${folder}/*/*/*.md)
  list(APPEND pages ${found})
endforeach()
list(FILTER pages EXCLUDE REGEX "^(build|out|tests)")
foreach(page IN LISTS pages ITEMS tools/view/view.png)
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} COMPONENT doc
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/quadrille-doc/${folder})
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples COMPONENT doc
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/quadrille-doc PATTERN examples/CMakeLists.txt EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/CITATION.cff COMPONENT doc
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/quadrille-doc)

# Units of systemd, for those who want them: systemctl link or enable them after the installation. They
# start the programs where these are installed.
foreach(unit quadrille-detector quadrille-grasp-planner)
  install(CODE "
    cmake_path(APPEND CMAKE_INSTALL_PREFIX \"${CMAKE_INSTALL_BINDIR}\" OUTPUT_VARIABLE QUADRILLE_BINDIR)
    configure_file(\"${PROJECT_SOURCE_DIR}/tools/packaging/systemd/${unit}.service.in\"
                   \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/systemd/system/${unit}.service\" @ONLY)")
endforeach()

add_custom_target(quadrille_installed DEPENDS quadrille_grasping quadrille_bus quadrille_manuals)
if(TARGET quadrille_python)
  add_dependencies(quadrille_installed quadrille_python)
endif()
