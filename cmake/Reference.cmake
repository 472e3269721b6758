# `cmake --build build/release --target reference` writes build/release/reference/html/index.html.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  configure_file(cmake/Doxyfile.in Doxyfile @ONLY)
  add_custom_target(reference COMMAND Doxygen::doxygen Doxyfile VERBATIM)
endif()
