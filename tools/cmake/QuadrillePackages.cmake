# Debian packages by CPack, one a component: tools/package makes them. Whoever installs something
# more names its component: runtime, dev, python or doc.
file(STRINGS /etc/os-release os_name REGEX "^ID=")
file(STRINGS /etc/os-release os_version REGEX "^VERSION_ID=")
string(REGEX REPLACE "VERSION_ID|ID|[^a-z0-9.]" "" os_release "${os_name}${os_version}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_COMPONENTS_ALL runtime dev doc)
if(TARGET quadrille_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_VENDOR "the quadrille authors")
# Each component's description begins with a summary of its own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGE_CONTACT "the quadrille authors <maintainers@quadrille.invalid>")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# What Debian wants of a package and an installation by hand does not.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/tools/packaging/debian/finish.cmake)
set(CPACK_QUADRILLE_SOURCE_DIR ${PROJECT_SOURCE_DIR})

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Packages need the libraries of the system that they were built on, and tell which by their version.
set(CPACK_DEBIAN_PACKAGE_RELEASE 1+${os_release})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# quadrille_package(COMPONENT NAME SECTION DEPENDS DESCRIPTION): what is in the package, and what it needs
# beside shared libraries, which are found.
function(quadrille_package component name section depends description)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS ${depends} PARENT_SCOPE)
  set(CPACK_COMPONENT_${key}_DESCRIPTION ${description} PARENT_SCOPE)
endfunction()

quadrille_package(runtime quadrille science ""
"finds quadrics in point clouds and plans grasps
Spheres, cylinders, cones, ellipsoids, bowls, planes and more are found in
point clouds, and two-finger grasps are planned on them.

The package has the command quadrille, the LCM processes quadrille-detector
and quadrille-grasp-planner with their systemd units (none is enabled), and
descriptions of grippers.")
quadrille_package(dev libquadrille-dev libdevel
"libeigen3-dev, libfcl-dev, liboctomap-dev, liblcm-dev"
"finds quadrics and plans grasps - libraries
C++20 libraries that find quadric surfaces in point clouds and plan two-finger
grasps on them, for CMake and pkg-config.

The package has the headers and static libraries, the types of LCM messages
as C++ headers and as .lcm files, and examples.")
# A module is for one version of Python.
get_directory_property(python_minor DIRECTORY tools/python DEFINITION Python3_VERSION_MINOR)
math(EXPR next_python_minor "0${python_minor} + 1")
quadrille_package(python python3-quadrille python
"python3 (>= 3.${python_minor}), python3 (<< 3.${next_python_minor}~), python3-numpy"
"finds quadrics and plans grasps - Python package
Python 3 package that finds quadric surfaces in point clouds, which are arrays
of numpy, and plans two-finger grasps on them.")
quadrille_package(doc quadrille-doc doc ""
"finds quadrics and plans grasps - documentation
The manual of quadrille, which finds quadric surfaces in point clouds and
plans two-finger grasps on them; how it is built, what the paper's experiments
gave, the pages of the C++ API, and examples in C++ and Python.")
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "gnuplot-nox, liblcm-bin, quadrille-doc")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "quadrille, quadrille-doc")
set(scripts ${PROJECT_SOURCE_DIR}/tools/packaging/debian)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${scripts}/quadrille/prerm
    ${scripts}/quadrille/postinst ${scripts}/quadrille/postrm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${scripts}/python3-quadrille/postinst
    ${scripts}/python3-quadrille/prerm)

include(CPack)
