# The compiler options of all our own targets, as one interface target.
option(RICOCHET_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(RICOCHET_WERROR "Treat warnings as errors" ON)

add_library(ricochet_options INTERFACE)
target_include_directories(ricochet_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(ricochet_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor
  -Wno-maybe-uninitialized  # GCC 12 cannot tell through dual numbers, nor through the sanitizers
  $<$<BOOL:${RICOCHET_WERROR}>:-Werror>)
if(RICOCHET_SANITIZE)
  # The three checks left out triple the time to compile; the address sanitizer sees a null pointer
  # that is followed, and x86 needs no alignment.
  target_compile_options(ricochet_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=null,vptr,alignment
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(ricochet_options INTERFACE -fsanitize=address,undefined)
  # Under the address sanitizer Eigen allocates in another way, but what pagmo's library allocates is
  # freed here, by its headers.
  target_compile_definitions(ricochet_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
