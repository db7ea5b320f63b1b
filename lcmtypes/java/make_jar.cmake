# Makes the jar: cmake -DLCM_GEN=… -DSCHEMAS=FOLDER -DJAVAC=… -DJAR_TOOL=… -DLCM_JAR=… -DWORK=FOLDER
# -DJAR=FILE -P make_jar.cmake
file(REMOVE_RECURSE ${WORK})
file(GLOB schemas ${SCHEMAS}/*.lcm)
execute_process(COMMAND ${LCM_GEN} --java --jpath ${WORK}/sources ${schemas}
                COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(GLOB_RECURSE sources ${WORK}/sources/*.java)
foreach(source IN LISTS sources)
  # lcm-gen 1.3 passes 64-bit sizes, as in drake.lcmt_point_cloud, where Java expects int; add casts.
  file(READ ${source} text)
  string(REGEX REPLACE ", 0, ((this\\.)?[A-Za-z0-9_]+)\\)" ", 0, (int) \\1)" text "${text}")
  file(WRITE ${source} "${text}")
endforeach()
execute_process(COMMAND ${JAVAC} -nowarn -cp ${LCM_JAR} -d ${WORK}/classes ${sources}
                COMMAND_ERROR_IS_FATAL ANY)
cmake_path(GET JAR PARENT_PATH folder)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${JAR_TOOL} cf ${JAR} -C ${WORK}/classes . COMMAND_ERROR_IS_FATAL ANY)
