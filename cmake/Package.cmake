# What `cpack -G DEB` makes: packages of Debian, each a component of Install.cmake.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The authors of ricochet <ricochet@localhost>")
set(CPACK_PACKAGE_VENDOR ricochet)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
find_program(RICOCHET_SHLIBDEPS dpkg-shlibdeps)
if(NOT RICOCHET_SHLIBDEPS)
  return()  # not on Debian
endif()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

# The files that Debian wants of each package: the licence and the changes, in its own forms.
set(debian ${PROJECT_BINARY_DIR}/debian)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS LICENSE CHANGELOG.md)
file(READ LICENSE licence)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" copyright "${licence}")
set(copyright "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^.*Copyright [^\n]*\n+" "" licence "${licence}")
string(STRIP "${licence}" licence)
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")
file(CONFIGURE OUTPUT debian/copyright @ONLY CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: ricochet

Files: *
Copyright: @copyright@
License: Expat

License: Expat
 @licence@
")
execute_process(
  COMMAND ${PROJECT_SOURCE_DIR}/cmake/debian/changelog ${CPACK_PACKAGE_CONTACT}
  COMMAND gzip -9nc
  INPUT_FILE ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${debian}/changelog.gz
  COMMAND_ERROR_IS_FATAL ANY)

# ricochet_package(NAME SECTION SUMMARY DESCRIPTION [DEPENDS ...] [RECOMMENDS ...] [SUGGESTS ...]): what
# programs and libraries are linked with is added to what it depends on.
set(CPACK_COMPONENTS_ALL "")
macro(ricochet_package name section summary description)
  list(APPEND CPACK_COMPONENTS_ALL ${name})
  string(TOUPPER ${name} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${description}")
  cmake_parse_arguments(relations "" "" "DEPENDS;RECOMMENDS;SUGGESTS" ${ARGN})
  foreach(relation DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN relations_${relation} ", " CPACK_DEBIAN_${upper}_PACKAGE_${relation})
  endforeach()
  install(FILES ${debian}/copyright ${debian}/changelog.gz DESTINATION share/doc/${name}
    COMPONENT ${name} EXCLUDE_FROM_ALL)
  set(package ${name})
  configure_file(cmake/debian/overrides.in debian/overrides/${name} @ONLY)
  install(FILES ${debian}/overrides/${name} DESTINATION share/lintian/overrides
    COMPONENT ${name} EXCLUDE_FROM_ALL)
endmacro()

set(solver_packages libnlopt-cxx-dev)
set(backends CERES DLIB IPOPT PAGMO)
set(packages libceres-dev libdlib-dev coinor-libipopt-dev libpagmo-dev)
foreach(backend package IN ZIP_LISTS backends packages)
  if(RICOCHET_HAS_${backend})
    list(APPEND solver_packages ${package})
  endif()
endforeach()
set(same_version "(= ${PROJECT_VERSION})")
ricochet_package(ricochet science "fastest quiet speed of a braiding machine, and a benchmark of solvers"
"ricochet simulates a yarn carrier that rattles in the track of a braiding
machine and counts its impacts. It finds how fast the machine may turn, and
benchmarks solvers of nonlinear programming on that question."
  SUGGESTS ricochet-mpi ricochet-tao python3-ricochet python3-scipy libricochet-dev)
ricochet_package(libricochet${abi} libs "problems of ricochet, for programs of any language"
"The shared library through which optimisers ask for values and derivatives of
the problems of ricochet.")
ricochet_package(libricochet-minimise${abi} libs "solvers of ricochet, for functions of any language"
"The shared library through which programs minimise functions of their own by
the solvers of ricochet."
  SUGGESTS ricochet-tao python3-scipy)
file(CONFIGURE OUTPUT debian/shlibs CONTENT "libricochet @abi@ libricochet@abi@ @same_version@
libricochet_minimise @abi@ libricochet-minimise@abi@ @same_version@\n")
file(CONFIGURE OUTPUT debian/triggers CONTENT "activate-noawait ldconfig\n")
foreach(library LIBRICOCHET${abi} LIBRICOCHET-MINIMISE${abi})
  set(CPACK_DEBIAN_${library}_PACKAGE_CONTROL_EXTRA ${debian}/shlibs ${debian}/triggers)
endforeach()
ricochet_package(libricochet-dev libdevel "libraries of ricochet, for programs in C and C++"
"Headers, static libraries and find_package(ricochet) for CMake: simulate a
machine, run solvers. ricochet::solvers needs the suggested packages."
  DEPENDS "libricochet${abi} ${same_version}" libeigen3-dev libfmt-dev libtbb-dev libtomlplusplus-dev
  SUGGESTS "libricochet-minimise${abi} ${same_version}" ${solver_packages})
ricochet_package(python3-ricochet python "problems of ricochet, for optimisers in Python"
"The module ricochet: values, derivatives and constraints of the problems of
ricochet as NumPy arrays, and its solvers for functions in Python."
  DEPENDS "libricochet${abi} ${same_version}" python3 python3-numpy
  RECOMMENDS "libricochet-minimise${abi} ${same_version}" python3-pandas)
set(CPACK_DEBIAN_PYTHON3-RICOCHET_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON3-RICOCHET_PACKAGE_CONTROL_EXTRA
  ${PROJECT_SOURCE_DIR}/cmake/debian/python/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/python/prerm)
if(TARGET ricochet_mpi)
  ricochet_package(ricochet-mpi science "campaigns of ricochet over the ranks of MPI"
"The program ricochet-mpi, which carries the command `ricochet run` over a
cluster."
    DEPENDS "ricochet ${same_version}" RECOMMENDS openmpi-bin)
endif()
if(TARGET ricochet_tao)
  ricochet_package(ricochet-tao science "solvers of TAO, a part of PETSc, for ricochet"
"A plugin of ricochet with TAO's solvers, such as POUNDERS and BLMVM."
    DEPENDS "ricochet ${same_version}")
endif()
include(CPack)
