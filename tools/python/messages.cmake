# Builds the messages for Python with lcm-gen, in the package `quadrille` (quadrille.quadrics_t).
# Messages of other packages go below it (quadrille.drake and quadrille.bot_core), so that they
# clash with no other software's. CMakeLists.txt includes this file; run with -P it makes the
# messages, given LCM_GEN, SCHEMAS (folder), PACKAGE (folder), WORK (folder), and LIST (the file
# that imports quadrille's own types).
if(NOT CMAKE_SCRIPT_MODE_FILE)
  # quadrille_python_messages(PACKAGE LIST) builds the messages into the folder PACKAGE.
  function(quadrille_python_messages package list)
    file(GLOB schemas CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lcmtypes/*.lcm)
    set(script ${PROJECT_SOURCE_DIR}/tools/python/messages.cmake)
    add_custom_command(
      OUTPUT ${package}/${list} ${package}/drake ${package}/bot_core
      COMMAND ${CMAKE_COMMAND} -DLCM_GEN=${LCM_GEN} -DSCHEMAS=${PROJECT_SOURCE_DIR}/lcmtypes
              -DPACKAGE=${package} -DWORK=${CMAKE_CURRENT_BINARY_DIR}/messages -DLIST=${list}
              -P ${script}
      DEPENDS ${schemas} ${script}
      COMMENT "Generating the messages for Python" VERBATIM)
    add_custom_target(quadrille_python_messages ALL DEPENDS ${package}/${list})
  endfunction()
  return()
endif()

# mended(FILE) corrects two errors of lcm-gen 1.3: a byte array begins as "", which cannot be
# encoded, and an array of booleans is decoded into an iterator, which can be read only once.
function(mended file)
  file(READ ${file} text)
  string(REGEX MATCHALL "bytearray\\(self\\.[A-Za-z0-9_]+" arrays "${text}")
  foreach(array IN LISTS arrays)
    string(REPLACE "bytearray(" "" array "${array}")
    string(REGEX REPLACE "(${array} = )(\"\"|None)\n" "\\1b\"\"\n" text "${text}")
  endforeach()
  string(REGEX REPLACE "= map\\(bool, ([^\n]*)\\)\n" "= list(map(bool, \\1))\n" text "${text}")
  # The generated code has no types to check.
  file(WRITE ${file} "# mypy: ignore-errors\n${text}")
endfunction()

file(REMOVE_RECURSE ${WORK})
file(GLOB own ${SCHEMAS}/quadrille_*.lcm)
file(GLOB others ${SCHEMAS}/*.lcm)
list(REMOVE_ITEM others ${own})
foreach(arguments IN ITEMS "${own}" "--package-prefix;quadrille;${others}")
  execute_process(COMMAND ${LCM_GEN} --python --ppath ${WORK} ${arguments}
                  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endforeach()
# The list is written here, because that of lcm-gen 1.3 is incomplete if packages have a prefix.
foreach(list IN ITEMS ${LIST} drake/__init__.py bot_core/__init__.py)
  cmake_path(GET list PARENT_PATH folder)
  file(REMOVE ${WORK}/quadrille/${folder}/__init__.py)
  file(GLOB modules ${WORK}/quadrille/${folder}/*.py)
  set(imports "# mypy: implicit-reexport\n\"\"\"Messages of LCM, made by lcm-gen.\"\"\"\n\n")
  foreach(module IN LISTS modules)
    mended(${module})
    cmake_path(GET module STEM name)
    string(APPEND imports "from .${name} import ${name}\n")
  endforeach()
  file(WRITE ${WORK}/quadrille/${list} "${imports}")
endforeach()
file(COPY ${WORK}/quadrille/ DESTINATION ${PACKAGE})
file(TOUCH ${PACKAGE}/${LIST} ${PACKAGE}/drake ${PACKAGE}/bot_core)
