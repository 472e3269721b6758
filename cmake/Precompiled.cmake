# What most files include, compiled once: reading these headers is half the work of a build.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)  # ccache would store none of the files that use one
endif()

# ricochet_targets(OUT FOLDER...): all targets made in the folders and below.
function(ricochet_targets out)
  set(found)
  foreach(folder ${ARGN})
    get_filename_component(folder ${folder} ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    ricochet_targets(targets_below ${below})
    list(APPEND found ${targets} ${targets_below})
  endforeach()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# ricochet_precompile(HOST FOLDER...): the targets of the folders share one header, made for HOST.
function(ricochet_precompile host)
  target_precompile_headers(${host} PRIVATE
    <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers>
    <optional> <span> <stdexcept> <string> <string_view> <utility> <vector>
    <Eigen/Core> <ceres/jet.h> <fmt/format.h> <nlohmann/json.hpp> <tbb/parallel_for.h>)
  ricochet_targets(targets ${ARGN})
  list(REMOVE_ITEM targets ${host})
  foreach(target ${targets})
    target_precompile_headers(${target} REUSE_FROM ${host})
  endforeach()
endfunction()

# ricochet_compile_fast(FOLDER...): with -O1, which gives the same numbers, a little later.
function(ricochet_compile_fast)
  ricochet_targets(targets ${ARGN})
  foreach(target ${targets})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endforeach()
endfunction()
