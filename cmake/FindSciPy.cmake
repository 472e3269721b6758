# SciPy of Debian's Python; another Python may stand before it in the path. Sets SciPy_VERSION and
# SciPy_FILE, the module's own file.
find_program(RICOCHET_PYTHON python3 HINTS /usr/bin)
set(SciPy_VERSION "")
set(SciPy_FILE "")
if(RICOCHET_PYTHON)
  execute_process(
    COMMAND ${RICOCHET_PYTHON} -I -c "import scipy; print(scipy.__version__, scipy.__file__, end='')"
    OUTPUT_VARIABLE found ERROR_QUIET)
  if(found MATCHES "^([^ ]+) (.+)$")
    set(SciPy_VERSION ${CMAKE_MATCH_1})
    set(SciPy_FILE ${CMAKE_MATCH_2})
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SciPy REQUIRED_VARS SciPy_FILE VERSION_VAR SciPy_VERSION)
if(SciPy_FOUND AND NOT TARGET SciPy::SciPy)
  add_library(SciPy::SciPy INTERFACE IMPORTED)
endif()
