# Installs the build into an empty folder, builds three projects with what is there, and runs them:
#   cmake -D BUILD=... -D EXAMPLES=... -D FOLDER=... -D COMPILER=... -P install_and_use.cmake
# EXAMPLES has two projects in C++, of a solver and of a machine; beside this file is one in C.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(build source folder)
  run(${CMAKE_COMMAND} -G Ninja -S ${source} -B ${folder} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${FOLDER}/prefix ${ARGN})
  run(${CMAKE_COMMAND} --build ${folder})
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix)
build(${EXAMPLES}/solvers/library ${FOLDER}/build)
run(${FOLDER}/build/consumer)
# The machine needs nothing that only solvers are made of.
foreach(package Boost Ceres NLopt Pagmo PkgConfig dlib)
  list(APPEND without -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
build(${EXAMPLES}/machine ${FOLDER}/machine ${without})
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
build(${CMAKE_CURRENT_LIST_DIR} ${FOLDER}/asks ${without})
run(${FOLDER}/asks/asks)
run(${FOLDER}/prefix/bin/ricochet list solvers)
foreach(file __init__.py _scene.py py.typed)
  if(NOT EXISTS ${FOLDER}/prefix/lib/python3/dist-packages/ricochet/${file})
    message(FATAL_ERROR "the Python package is not installed: ${file} is missing")
  endif()
endforeach()
run(python3 ${CMAKE_CURRENT_LIST_DIR}/links.py ${FOLDER}/prefix/share/doc/ricochet)

# What find_package(ricochet) leaves behind and prints.
function(find folder result)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/quiet -B ${FOLDER}/${folder}
      -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${FOLDER}/prefix ${ARGN}
    OUTPUT_VARIABLE output ERROR_VARIABLE error RESULT_VARIABLE code)
  set(output "${output}" PARENT_SCOPE)
  set(error "${error}" PARENT_SCOPE)
  if(code AND result)
    message(FATAL_ERROR "${folder}: find_package(ricochet) leaves traces:\n${output}${error}")
  elseif(result AND NOT "${error}|${output}" MATCHES "^\\|.*\n-- finding\n-- found\n")
    message(FATAL_ERROR "${folder}: find_package(ricochet) prints:\n${output}${error}")
  elseif(NOT code AND NOT result)
    message(FATAL_ERROR "${folder}: ricochet is found without what it needs:\n${output}${error}")
  endif()
endfunction()
find(quiet_all TRUE)
find(quiet_machine TRUE -D COMPONENTS=carrier_track ${without})
find(without_pagmo FALSE -D CMAKE_DISABLE_FIND_PACKAGE_Pagmo=ON)
if(NOT error MATCHES "ricochet's solvers need Pagmo;")
  message(FATAL_ERROR "find_package(ricochet) does not say what is missing:\n${error}")
endif()
find(unknown FALSE -D COMPONENTS=carriage)
