# The compiler options of all our own targets, as one interface target.
set(RICOCHET_SANITIZE "" CACHE STRING "Sanitizers to build with: address (undefined behaviour too) or thread")
set_property(CACHE RICOCHET_SANITIZE PROPERTY STRINGS "" address thread)
include(GNUInstallDirs)

add_library(ricochet_options INTERFACE)
target_include_directories(ricochet_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>  # "src/core/scorer.h"
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>  # "ricochet/problem.h"
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(ricochet_options INTERFACE cxx_std_20)
target_link_libraries(ricochet_options INTERFACE $<BUILD_INTERFACE:fmt::fmt>)
# Errors of JSON name the place in the data, "(/rows/3/share)".
target_compile_definitions(ricochet_options INTERFACE $<BUILD_INTERFACE:JSON_DIAGNOSTICS=1>)
set(warnings -Wall -Wextra -Wpedantic -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 is mistaken in the last three, through dual numbers or a precompiled header.
  # A global of one file is none to the next, though both are compiled at once.
  list(APPEND warnings -Wconversion $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,-Wshadow=local,-Wshadow>
    -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overread)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(APPEND warnings -Wno-overlength-strings)  # an embedded data file is one string
endif()
target_compile_options(ricochet_options INTERFACE "$<BUILD_INTERFACE:${warnings}>")
if(RICOCHET_SANITIZE STREQUAL "address")
  # The three checks left out triple the time to compile; the address sanitizer sees a null pointer
  # that is followed, and x86 needs no alignment.
  target_compile_options(ricochet_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=null,vptr,alignment
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(ricochet_options INTERFACE -fsanitize=address,undefined)
  # Under the address sanitizer Eigen allocates in another way, but what pagmo's library allocates is
  # freed here, by its headers.
  target_compile_definitions(ricochet_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
elseif(RICOCHET_SANITIZE STREQUAL "thread")
  target_include_directories(ricochet_options BEFORE INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/tests/thread>)
  target_compile_options(ricochet_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(ricochet_options INTERFACE -fsanitize=thread)
elseif(RICOCHET_SANITIZE)
  message(FATAL_ERROR "RICOCHET_SANITIZE is ${RICOCHET_SANITIZE}; allowed: nothing, address, thread")
endif()

add_library(ricochet_dual_numbers INTERFACE)  # ceres/jet.h
target_include_directories(ricochet_dual_numbers SYSTEM INTERFACE ${RICOCHET_JET_FOLDER})
