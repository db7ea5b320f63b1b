# Finishes the trees that CPack packs, one a component: copyright and changelogs, packed manual pages.
# A CPack script, for its variables.
function(pack_file path)
  execute_process(COMMAND gzip -9nf ${path} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# SOURCE_DATE_EPOCH sets the date of repeatable packages.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(scripts ${CPACK_QUADRILLE_SOURCE_DIR}/tools/packaging/debian)
file(READ ${CPACK_QUADRILLE_SOURCE_DIR}/LICENSE license)
string(REGEX REPLACE "^[^\n]*\n\nCopyright [^\n]*\n\n" "" license "${license}")
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(STRIP "${license}" license)
string(REPLACE "\n" "\n " license "${license}")

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(tree ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share)
  if(NOT EXISTS ${CPACK_TEMPORARY_DIRECTORY}/${component})
    continue()
  endif()
  string(TOUPPER ${component} key)
  set(doc ${tree}/doc/${CPACK_DEBIAN_${key}_PACKAGE_NAME})
  configure_file(${scripts}/copyright.in ${doc}/copyright @ONLY)
  configure_file(${CPACK_QUADRILLE_SOURCE_DIR}/CHANGELOG.md ${doc}/changelog COPYONLY)
  file(WRITE ${doc}/changelog.Debian
       "quadrille (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) stable; urgency=medium\n\n"
       "  * Packages of quadrille ${CPACK_PACKAGE_VERSION}; changelog.gz tells what is new.\n\n"
       " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  pack_file(${doc}/changelog)
  pack_file(${doc}/changelog.Debian)
  file(GLOB manuals ${tree}/man/man*/*.[1-9])
  foreach(manual IN LISTS manuals)
    pack_file(${manual})
  endforeach()
endforeach()
