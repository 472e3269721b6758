# Installs a build that has only the program ricochet and what it is linked with, as `./ricochet list`
# leaves it:
#   cmake -D BUILD=... -D MACHINE=... -D FOLDER=... -D COMPILER=... -P install_partly.cmake
# The rules are those of the build, for a folder with a part of its files. MACHINE is a project that uses
# the library.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
set(parts ricochetConfig.cmake ricochetConfigVersion.cmake src/app/ricochet)
foreach(library core carrier_track classic problems seen_problem solvers)
  list(APPEND parts */libricochet_${library}.a)
endforeach()
list(TRANSFORM parts PREPEND ${BUILD}/)
file(GLOB_RECURSE parts RELATIVE ${BUILD} ${parts} ${BUILD}/CMakeFiles/Export/*)
foreach(part IN LISTS parts)
  cmake_path(GET part PARENT_PATH folder)
  file(COPY ${BUILD}/${part} DESTINATION ${FOLDER}/build/${folder})
endforeach()
file(READ ${BUILD}/cmake_install.cmake rules)
string(REGEX REPLACE "include\\(\"[^\"]*\"\\)" "" rules "${rules}")  # of folders without rules
string(REPLACE "${BUILD}/" "${FOLDER}/build/" rules "${rules}")
file(WRITE ${FOLDER}/build/cmake_install.cmake "${rules}")

execute_process(COMMAND ${CMAKE_COMMAND} --install ${FOLDER}/build --prefix ${FOLDER}/prefix
  OUTPUT_VARIABLE output ERROR_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
foreach(target ricochet_studies ricochet_reproduce ricochet_interface ricochet_descriptions)
  if(NOT output MATCHES "Not installed, for it is not built: ${target} ")
    message(FATAL_ERROR "installing does not say that ${target} is missing:\n${output}")
  endif()
endforeach()
if(output MATCHES "not built: ricochet(_core)? ")
  message(FATAL_ERROR "installing says that what is there is missing:\n${output}")
endif()
run(${FOLDER}/prefix/bin/ricochet list solvers)
run(${CMAKE_COMMAND} -G Ninja -S ${MACHINE} -B ${FOLDER}/machine -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${FOLDER}/prefix)
run(${CMAKE_COMMAND} --build ${FOLDER}/machine)
