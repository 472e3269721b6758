# Installs the build into an empty folder, builds two projects with what is there, and runs them:
#   cmake -D BUILD=... -D SOURCE=... -D FOLDER=... -D COMPILER=... -P install_and_use.cmake
# SOURCE is the project in C++; beside this file is the one in C.
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
build(${SOURCE} ${FOLDER}/build)
run(${FOLDER}/build/consumer)
build(${CMAKE_CURRENT_LIST_DIR} ${FOLDER}/asks)
run(${FOLDER}/asks/asks)
run(${FOLDER}/prefix/bin/ricochet list solvers)
if(NOT EXISTS ${FOLDER}/prefix/lib/python3/dist-packages/ricochet.py)
  message(FATAL_ERROR "the Python module is not installed")
endif()
