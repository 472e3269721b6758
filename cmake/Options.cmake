# The compiler options of all our own targets, as one interface target; who links our libraries has none of it.
set(RICOCHET_SANITIZE "" CACHE STRING "Sanitizers to build with: address (undefined behaviour too) or thread")
set_property(CACHE RICOCHET_SANITIZE PROPERTY STRINGS "" address thread)
set(RICOCHET_SANITIZE_ROOMS "" CACHE STRING "Rooms of tests/ that the sanitizers look at; all unless told otherwise")
include(GNUInstallDirs)

add_library(ricochet_options INTERFACE)
target_include_directories(ricochet_options INTERFACE
  ${PROJECT_SOURCE_DIR}  # "src/core/evaluator.h"
  ${PROJECT_SOURCE_DIR}/include)  # "ricochet/problem.h"
target_compile_features(ricochet_options INTERFACE cxx_std_20)
target_link_libraries(ricochet_options INTERFACE fmt::fmt)
# Errors of JSON name the place in the data, "(/rows/3/share)".
target_compile_definitions(ricochet_options INTERFACE JSON_DIAGNOSTICS=1)
set(warnings -Wall -Wextra -Wpedantic -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 is mistaken in the last three, through dual numbers or a precompiled header.
  # A global of one file is none to the next, though both are compiled at once.
  list(APPEND warnings -Wconversion $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,-Wshadow=local,-Wshadow>
    -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overread)
  # To collect garbage first at 600 MB takes 200 MB more, and a tenth of the time less.
  target_compile_options(ricochet_options INTERFACE --param=ggc-min-heapsize=600000)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(APPEND warnings -Wno-overlength-strings)  # an embedded data file is one string
endif()
target_compile_options(ricochet_options INTERFACE ${warnings})
if(RICOCHET_SANITIZE STREQUAL "address")
  # The three checks left out triple the time to compile; the address sanitizer sees a null pointer
  # that is followed, and x86 needs no alignment.
  set(sanitizers -fsanitize=address,undefined -fno-sanitize=null,vptr,alignment
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_options(ricochet_options INTERFACE
    "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:RICOCHET_UNSANITIZED>>>:${sanitizers}>")
  target_link_options(ricochet_options INTERFACE -fsanitize=address,undefined)
  # Under the address sanitizer Eigen allocates in another way, but what pagmo's library allocates is
  # freed here, by its headers.
  target_compile_definitions(ricochet_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
elseif(RICOCHET_SANITIZE STREQUAL "thread")
  target_include_directories(ricochet_options BEFORE INTERFACE
    ${PROJECT_SOURCE_DIR}/tests/thread)
  target_compile_options(ricochet_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(ricochet_options INTERFACE -fsanitize=thread)
elseif(RICOCHET_SANITIZE)
  message(FATAL_ERROR "RICOCHET_SANITIZE is ${RICOCHET_SANITIZE}; allowed: nothing, address, thread")
endif()

target_include_directories(ricochet_options SYSTEM INTERFACE ${RICOCHET_JET_FOLDER})  # ceres/jet.h

# ricochet_targets(OUT FOLDER...): all targets made in the folders and below that are compiled.
function(ricochet_targets out)
  set(found)
  foreach(folder ${ARGN})
    get_filename_component(folder ${folder} ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    ricochet_targets(targets_below ${below})
    list(APPEND found ${targets_below})
    foreach(target ${targets})
      get_target_property(type ${target} TYPE)
      if(NOT type MATCHES "UTILITY|INTERFACE")
        list(APPEND found ${target})
      endif()
    endforeach()
  endforeach()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# ricochet_own(FOLDER...): gives the options to all targets in the folders, and to nobody who links them: a
# property, since target_link_libraries(PRIVATE) would have the options installed. A target with the property
# RICOCHET_AS_A_USER does without.
function(ricochet_own)
  ricochet_targets(targets ${ARGN})
  foreach(target ${targets})
    get_target_property(as_a_user ${target} RICOCHET_AS_A_USER)
    if(NOT as_a_user)
      set_property(TARGET ${target} APPEND PROPERTY LINK_LIBRARIES ricochet_options)
    endif()
  endforeach()
endfunction()
