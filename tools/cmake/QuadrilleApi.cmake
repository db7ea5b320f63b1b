# The pages of the C++ API by Doxygen, of all public headers: target quadrille_api, where there is
# Doxygen (tools/setup --package). A comment that Doxygen cannot read is an error.
find_package(Doxygen QUIET)
if(NOT Doxygen_FOUND)
  message(STATUS "No Doxygen: no pages of the API (tools/setup --package)")
  return()
endif()

set(DOXYGEN_PROJECT_NAME quadrille)
set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/api)
set(DOXYGEN_STRIP_FROM_PATH detector/include grasping/include lcmtypes/bus/include)
set(DOXYGEN_STRIP_FROM_INC_PATH ${DOXYGEN_STRIP_FROM_PATH})
set(DOXYGEN_FILE_PATTERNS *.hpp *.md)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
# A parameter whose name says all has no line.
set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED QUADRILLE_EXPORT=)
set(DOXYGEN_GENERATE_LATEX NO)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_HTML_TIMESTAMP NO)
doxygen_add_docs(quadrille_api tools/packaging/api.md detector/include grasping/include
                 lcmtypes/bus/include COMMENT "Pages of the API")
add_dependencies(quadrille_installed quadrille_api)
# It is there if what is installed was built by its target, as for packages.
install(DIRECTORY ${PROJECT_BINARY_DIR}/api/html/ COMPONENT doc OPTIONAL
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/quadrille-doc/api)
