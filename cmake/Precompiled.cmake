# What most files include, compiled once: reading these headers is half the work of a build.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)  # ccache would store none of the files that use one
endif()

# ricochet_apart(FILE...): files that the preset release, which compiles several files of a target at
# once, must compile alone: for names in them, or in the headers of another's library, are those of
# other files of the target, or for they take long.
function(ricochet_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# ricochet_headers(NAME OPTION...): a target with the precompiled header of those that are compiled with the
# same options. A header keeps the optimisation that it was made with, and may know no macro that a file does
# not.
function(ricochet_headers name)
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(${name} PRIVATE ricochet_options Eigen3::Eigen)
  target_compile_options(${name} PRIVATE ${ARGN})
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers>
    <optional> <span> <stdexcept> <string> <string_view> <utility> <vector>
    <Eigen/Core> <ceres/jet.h> <fmt/format.h> <nlohmann/json.hpp> <tbb/parallel_for.h>)
endfunction()

# ricochet_compile_like(HEADERS TARGET...): with the header, and the options that it was made with.
function(ricochet_compile_like headers)
  get_target_property(options ${headers} COMPILE_OPTIONS)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE ${options})
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endforeach()
endfunction()

# ricochet_fast_to_compile(TARGET...): for targets that keep books, or make words, pictures and pages: with
# the same results, a little later.
ricochet_headers(ricochet_fast_headers $<IF:$<CONFIG:Release>,-Og,-O0>)
function(ricochet_fast_to_compile)
  ricochet_compile_like(ricochet_fast_headers ${ARGN})
endfunction()

# ricochet_room(ROOM TARGET...): where sanitizers look at some rooms alone, and not at this one, its targets do without
# them: they are compiled in half the time, and run in a third.
if(RICOCHET_SANITIZE_ROOMS)
  ricochet_headers(ricochet_unsanitized_headers -fPIC)
  set_target_properties(ricochet_unsanitized_headers PROPERTIES RICOCHET_UNSANITIZED ON)
endif()
function(ricochet_room room)
  if(RICOCHET_SANITIZE_ROOMS AND NOT room IN_LIST RICOCHET_SANITIZE_ROOMS)
    set_target_properties(${ARGN} PROPERTIES RICOCHET_UNSANITIZED ON)
    ricochet_compile_like(ricochet_unsanitized_headers ${ARGN})
  endif()
endfunction()

# ricochet_compile_the_others(FOLDER...): all other targets of the folders. They compute, as the build type
# has it, and can be made into a shared library; without the last option GCC would inline less then.
ricochet_headers(ricochet_headers -fPIC -fno-semantic-interposition)
function(ricochet_compile_the_others)
  ricochet_targets(targets ${ARGN})
  foreach(target ${targets})
    get_target_property(headers ${target} PRECOMPILE_HEADERS_REUSE_FROM)
    if(NOT headers)
      ricochet_compile_like(ricochet_headers ${target})
    endif()
  endforeach()
endfunction()
