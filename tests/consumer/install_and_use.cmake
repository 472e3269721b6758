# Installs the build into an empty folder, builds three projects with what is there, and runs them:
#   cmake -D BUILD=... -D EXAMPLES=... -D FOLDER=... -D COMPILER=... -P install_and_use.cmake
# EXAMPLES has two projects in C++, of a solver and of a machine; beside this file is one in C.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(build source folder)
  run(${CMAKE_COMMAND} -G Ninja -S ${source} -B ${folder} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${FOLDER}/prefix)
  run(${CMAKE_COMMAND} --build ${folder})
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix)
build(${EXAMPLES}/solvers/library ${FOLDER}/build)
run(${FOLDER}/build/consumer)
build(${EXAMPLES}/machine ${FOLDER}/machine)
execute_process(COMMAND ${FOLDER}/machine/machine ${EXAMPLES}/machine.toml
  OUTPUT_VARIABLE from_library COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${FOLDER}/prefix/bin/ricochet threshold --scene ${EXAMPLES}/machine.toml --format json
  OUTPUT_VARIABLE from_program COMMAND_ERROR_IS_FATAL ANY)
# As text: string(JSON) would print 2.0499999999999998 for 2.05.
string(REGEX MATCH "\"fastest_quiet\": ([0-9.]+)" found "${from_program}")
set(speed "${CMAKE_MATCH_1}")
if(NOT found OR NOT from_library MATCHES "fastest_quiet ${speed}0*\n")
  message(FATAL_ERROR "the program says ${speed}, the library:\n${from_library}")
endif()
file(GLOB beside LIST_DIRECTORIES true ${FOLDER}/prefix/include/*)
if(NOT beside STREQUAL "${FOLDER}/prefix/include/ricochet")
  message(FATAL_ERROR "other headers than the public ones are installed: ${beside}")
endif()
build(${CMAKE_CURRENT_LIST_DIR} ${FOLDER}/asks)
run(${FOLDER}/asks/asks)
run(${FOLDER}/prefix/bin/ricochet list solvers)
if(NOT EXISTS ${FOLDER}/prefix/lib/python3/dist-packages/ricochet.py)
  message(FATAL_ERROR "the Python module is not installed")
endif()
