# Installs the build into an empty folder, builds the consumer with what is there, and runs it:
#   cmake -D BUILD=... -D SOURCE=... -D FOLDER=... -D COMPILER=... -P install_and_use.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix)
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -B ${FOLDER}/build -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${FOLDER}/prefix)
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${FOLDER}/build/consumer)
run(${FOLDER}/build/asks)
run(${FOLDER}/prefix/bin/ricochet list solvers)
if(NOT EXISTS ${FOLDER}/prefix/lib/python3/dist-packages/ricochet.py)
  message(FATAL_ERROR "the Python module is not installed")
endif()
