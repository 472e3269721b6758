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

# ricochet_precompile(NAME OPTION FOLDER...): compiles all targets of the folders, but for those that
# an earlier call has named, with the option and with one precompiled header, of that name. A header keeps the optimisation that it was
# made with, and may know no macro that a file does not: each has a target of its own.
function(ricochet_precompile name option)
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(${name} PRIVATE ricochet_options Eigen3::Eigen)
  target_compile_options(${name} PRIVATE ${option})
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers>
    <optional> <span> <stdexcept> <string> <string_view> <utility> <vector>
    <Eigen/Core> <ceres/jet.h> <fmt/format.h> <nlohmann/json.hpp> <tbb/parallel_for.h>)
  ricochet_targets(targets ${ARGN})
  foreach(target ${targets})
    get_target_property(other ${target} PRECOMPILE_HEADERS_REUSE_FROM)
    if(other)
      continue()
    endif()
    target_compile_options(${target} PRIVATE ${option})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endforeach()
endfunction()
