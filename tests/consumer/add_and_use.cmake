# Builds a program in a project that adds ricochet's tree by add_subdirectory, and runs it; the example of a
# machine is configured, but compiled by others:
#   cmake -D SOURCE=... -D FOLDER=... -D COMPILER=... -P add_and_use.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${FOLDER})
# Not optimised, many files at once: that is compiled soonest.
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/subdirectory -B ${FOLDER} -D SOURCE=${SOURCE}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_UNITY_BUILD=ON -D CMAKE_UNITY_BUILD_BATCH_SIZE=24)
file(STRINGS ${FOLDER}/INCLUDE_DIRECTORIES folders)
list(FILTER folders EXCLUDE REGEX "^/usr/include")
file(READ ${FOLDER}/COMPILE_OPTIONS options)
if(NOT folders STREQUAL "${SOURCE}/include" OR options MATCHES "[^\n]")
  message(FATAL_ERROR "ricochet brings more than its public headers: ${folders}\n${options}")
endif()
run(${CMAKE_COMMAND} --build ${FOLDER} --target draws)
execute_process(COMMAND ${FOLDER}/draws OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed MATCHES "^0\\.[0-9]+$")
  message(FATAL_ERROR "no number from 0 to 1: ${printed}")
endif()
