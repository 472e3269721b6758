# What the libraries need. Everything comes from Debian 12; the script `ricochet` lists the packages.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_path(RICOCHET_JET_FOLDER ceres/jet.h REQUIRED)  # dual numbers: a header of Ceres, not its library
# With both NLopt packages installed a plain search finds the C build, which lacks StoGO and AGS.
find_package(NLopt 2.7 CONFIG REQUIRED NO_DEFAULT_PATH
             PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/nlopt_cxx)
find_package(Boost 1.74 REQUIRED)  # headers: Odeint, Math, String
find_package(TBB REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
pkg_check_modules(md4c REQUIRED IMPORTED_TARGET md4c-html)  # Markdown to HTML

# ricochet_backend(NAME TARGET PACKAGE...): a library that a build can do without. RICOCHET_WITH_NAME
# is ON: required, OFF: left out, AUTO: used if found. RICOCHET_HAS_NAME says whether it is there.
macro(ricochet_backend name target)
  if(NOT DEFINED RICOCHET_WITH_${name})
    set(RICOCHET_WITH_${name} AUTO CACHE STRING "Build what needs ${name}: ON, OFF or AUTO")
    set_property(CACHE RICOCHET_WITH_${name} PROPERTY STRINGS ON OFF AUTO)
  endif()
  set(RICOCHET_NEED REQUIRED)
  if(RICOCHET_WITH_${name} STREQUAL "AUTO")
    set(RICOCHET_NEED QUIET)
  endif()
  set(RICOCHET_HAS_${name} OFF)
  if(RICOCHET_WITH_${name})
    if("${ARGV2}" STREQUAL "pkg-config")
      pkg_check_modules(${ARGV3} ${RICOCHET_NEED} IMPORTED_TARGET ${ARGV4})
    else()
      find_package(${ARGN} ${RICOCHET_NEED})
    endif()
    if(TARGET ${target})
      set(RICOCHET_HAS_${name} ON)
    endif()
  endif()
  message(STATUS "ricochet: with ${name}: ${RICOCHET_HAS_${name}}")
endmacro()

# The reference BLAS and LAPACK, ahead of those of ATLAS that come with Ceres: they sum in another order
# at another address, so that the last bits of Ipopt and dlib would depend on what a process did before.
set(RICOCHET_LINEAR_ALGEBRA "")
foreach(library lapack blas)
  find_library(RICOCHET_REFERENCE_${library} lib${library}.so.3 NO_DEFAULT_PATH
               PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/${library})
  if(RICOCHET_REFERENCE_${library})
    list(APPEND RICOCHET_LINEAR_ALGEBRA ${RICOCHET_REFERENCE_${library}})
  endif()
endforeach()
message(STATUS "ricochet: reference BLAS and LAPACK: ${RICOCHET_LINEAR_ALGEBRA}")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)  # where they are found when ricochet is installed, too

ricochet_backend(CERES Ceres::ceres Ceres 2.1)
ricochet_backend(DLIB dlib::dlib dlib 19.24)
if(RICOCHET_HAS_DLIB)
  # What we use needs no other library; the files named here may be missing. Linked statically, for
  # Debian's shared library brings 70 MB of data sets.
  find_library(RICOCHET_DLIB_ARCHIVE libdlib.a REQUIRED)
  set_target_properties(dlib::dlib PROPERTIES
    INTERFACE_LINK_LIBRARIES "" IMPORTED_LOCATION_NONE ${RICOCHET_DLIB_ARCHIVE})
endif()
ricochet_backend(IPOPT PkgConfig::Ipopt pkg-config Ipopt ipopt)
ricochet_backend(PAGMO Pagmo::pagmo Pagmo 2.18)
ricochet_backend(TAO PkgConfig::PETSc pkg-config PETSc PETSc)
ricochet_backend(SCIPY SciPy::SciPy SciPy 1.7)
ricochet_backend(SUNDIALS SUNDIALS::cvode SUNDIALS 6.4 COMPONENTS cvode nvecserial)
