# What `cmake --install` and `cpack -G DEB` bring: the program, the libraries that a solver or a
# problem of one's own is built with, their headers, the package for find_package(ricochet), and the
# C library with its Python module for optimisers outside.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ricochet)

set(libraries options dual_numbers core carrier_track classic problems seen_problem solvers interface)
foreach(library ${libraries})
  set_target_properties(ricochet_${library} PROPERTIES EXPORT_NAME ${library})
  list(APPEND library_targets ricochet_${library})
endforeach()
install(TARGETS ricochet ricochet_reproduce ricochet_studies)
if(TARGET ricochet_mpi)
  install(TARGETS ricochet_mpi)
endif()
install(TARGETS ${library_targets} EXPORT ricochet)
install(EXPORT ricochet NAMESPACE ricochet:: DESTINATION ${package_folder} FILE ricochetTargets.cmake)

install(DIRECTORY include/ricochet TYPE INCLUDE)
configure_package_config_file(cmake/ricochetConfig.cmake.in ricochetConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(ricochetConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/ricochetConfig.cmake ${PROJECT_BINARY_DIR}/ricochetConfigVersion.cmake
  cmake/Dependencies.cmake
  DESTINATION ${package_folder})
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE TYPE DOC)
install(DIRECTORY docs TYPE DOC)
install(FILES reports/archive/reference.archive DESTINATION share/ricochet)
install(FILES python/ricochet.py DESTINATION lib/python3/dist-packages)  # Debian's place for modules

# The manual and the completions, made of the one description of the commands.
set(descriptions ${PROJECT_BINARY_DIR}/descriptions)
foreach(form man bash zsh fish)
  add_custom_command(OUTPUT ${descriptions}/${form}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${descriptions}
    COMMAND ricochet describe ${form} > ${descriptions}/${form}
    DEPENDS ricochet ricochet_reproduce ricochet_studies VERBATIM)
endforeach()
add_custom_target(ricochet_descriptions ALL
  DEPENDS ${descriptions}/man ${descriptions}/bash ${descriptions}/zsh ${descriptions}/fish)
install(FILES ${descriptions}/man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME ricochet.1)
install(FILES ${descriptions}/bash RENAME ricochet
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${descriptions}/zsh RENAME _ricochet
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${descriptions}/fish RENAME ricochet.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# The package of Debian. Who builds with the library needs the -dev packages of what it is made of.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The authors of ricochet <ricochet@localhost>")
set(CPACK_PACKAGE_VENDOR ricochet)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
find_program(RICOCHET_SHLIBDEPS dpkg-shlibdeps)
if(RICOCHET_SHLIBDEPS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
endif()
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "libeigen3-dev, libceres-dev, libnlopt-cxx-dev, libboost-dev, libtbb-dev, libfmt-dev, libtomlplusplus-dev, pkg-config, python3-numpy")
if(RICOCHET_HAS_DLIB)
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", libdlib-dev")
endif()
if(RICOCHET_HAS_IPOPT)
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", coinor-libipopt-dev")
endif()
if(RICOCHET_HAS_PAGMO)
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", libpagmo-dev")
endif()
include(CPack)
