# What `cmake --install` brings, as far as it is built. A component is a package of Debian, see
# Package.cmake.
include(CMakePackageConfigHelpers)

# ricochet_missing(COMPONENT TARGET [FILE]): installing says that what the target makes is not there, and
# how to build it; making a package fails.
function(ricochet_missing component target)
  set(file $<TARGET_FILE:${target}>)
  if(ARGC GREATER 2)
    set(file ${ARGV2})
  endif()
  install(CODE "
    if(NOT EXISTS \"${file}\")
      if(CMAKE_INSTALL_PREFIX MATCHES \"_CPack_Packages\")
        message(FATAL_ERROR \"${target} is not built\")
      endif()
      message(\"-- Not installed, for it is not built: ${target} (ninja -C ${PROJECT_BINARY_DIR} ${target})\")
    endif()" COMPONENT ${component})
endfunction()

# ricochet_installed_runpath(TARGET...): built with the RUNPATH that they are installed with. CMake would
# end another one by a colon, to change it when installing: an empty entry, which is the current folder.
function(ricochet_installed_runpath)
  set_target_properties(${ARGN} PROPERTIES BUILD_WITH_INSTALL_RPATH ON)
endfunction()

# The programs, and the plugin with TAO's solvers.
ricochet_installed_runpath(ricochet ricochet_reproduce ricochet_studies ricochet_interface ricochet_minimise)
install(TARGETS ricochet ricochet_reproduce ricochet_studies OPTIONAL COMPONENT ricochet)
foreach(program ricochet ricochet_reproduce ricochet_studies)
  ricochet_missing(ricochet ${program})
endforeach()
if(TARGET ricochet_mpi)
  set_target_properties(ricochet_mpi PROPERTIES INSTALL_RPATH_USE_LINK_PATH OFF)
  ricochet_installed_runpath(ricochet_mpi)
  install(TARGETS ricochet_mpi OPTIONAL COMPONENT ricochet-mpi)
  ricochet_missing(ricochet-mpi ricochet_mpi)
endif()
if(TARGET ricochet_tao)
  set_target_properties(ricochet_tao PROPERTIES INSTALL_RPATH_USE_LINK_PATH OFF)
  ricochet_installed_runpath(ricochet_tao)
  install(TARGETS ricochet_tao OPTIONAL
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/ricochet COMPONENT ricochet-tao)
  ricochet_missing(ricochet-tao ricochet_tao)
endif()

# The libraries, with headers and find_package(ricochet). A set of them has its own file of targets, for
# a user need not have what another set is made of.
get_target_property(abi ricochet_interface SOVERSION)  # in the name of the package with the library
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ricochet)
set(problems_set core carrier_track classic problems)
set(solvers_set seen_problem solvers)
set(interface_set interface)
set(minimise_set minimise)
foreach(set problems solvers interface minimise)
  set(component libricochet${abi})
  if(set STREQUAL minimise)
    set(component libricochet-minimise${abi})
  endif()
  foreach(library ${${set}_set})
    set_target_properties(ricochet_${library} PROPERTIES EXPORT_NAME ${library})
    install(TARGETS ricochet_${library} EXPORT ricochet-${set} OPTIONAL
      ARCHIVE COMPONENT libricochet-dev
      LIBRARY COMPONENT ${component} NAMELINK_COMPONENT libricochet-dev)
    ricochet_missing(libricochet-dev ricochet_${library})
  endforeach()
endforeach()
foreach(set problems solvers interface minimise)
  install(EXPORT ricochet-${set} NAMESPACE ricochet:: DESTINATION ${package_folder}
    FILE ricochet-${set}.cmake COMPONENT libricochet-dev)
endforeach()
install(DIRECTORY include/ricochet TYPE INCLUDE COMPONENT libricochet-dev)
set(RICOCHET_SOLVER_PACKAGES "")  # what the solvers are made of, see ricochetConfig.cmake.in
set(RICOCHET_SOLVER_LIBRARIES "")
foreach(backend Ceres Pagmo)
  string(TOUPPER ${backend} name)
  if(RICOCHET_HAS_${name})
    string(APPEND RICOCHET_SOLVER_PACKAGES " \"${backend} ${${backend}_VERSION}\"")
  endif()
endforeach()
foreach(backend dlib ipopt)
  string(TOUPPER ${backend} name)
  if(RICOCHET_HAS_${name})
    string(APPEND RICOCHET_SOLVER_LIBRARIES " ${backend}")
  endif()
endforeach()
configure_file(cmake/ricochetConfig.cmake.in ricochetConfig.cmake @ONLY)
write_basic_package_version_file(ricochetConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/ricochetConfig.cmake ${PROJECT_BINARY_DIR}/ricochetConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT libricochet-dev)

add_subdirectory(python)

# The docs, with what they link to.
install(FILES README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff TYPE DOC COMPONENT ricochet)
install(FILES LICENSE TYPE DOC COMPONENT license)  # Debian has it as the file copyright
install(DIRECTORY docs examples TYPE DOC COMPONENT ricochet PATTERN __pycache__ EXCLUDE)
install(FILES include/ricochet/ricochet.h include/ricochet/minimise.h
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/include/ricochet COMPONENT ricochet)
install(DIRECTORY reports/reference DESTINATION ${CMAKE_INSTALL_DOCDIR}/reports COMPONENT ricochet
        FILES_MATCHING PATTERN *.md PATTERN *.svg)
install(DIRECTORY src/studies/simulators/tools/ DESTINATION share/ricochet/simulators COMPONENT ricochet)
install(FILES reports/archive/reference.archive DESTINATION share/ricochet COMPONENT ricochet)
install(FILES solvers/outside/scipy_solvers.py DESTINATION share/ricochet COMPONENT ricochet)

# The manual and the completions, made of the one description of the commands.
set(descriptions ${PROJECT_BINARY_DIR}/descriptions)
foreach(form man bash zsh fish)
  add_custom_command(OUTPUT ${descriptions}/${form}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${descriptions}
    COMMAND ricochet describe ${form} > ${descriptions}/${form}
    DEPENDS ricochet ricochet_reproduce ricochet_studies VERBATIM)
endforeach()
add_custom_command(OUTPUT ${descriptions}/man.gz
  COMMAND gzip -9nc ${descriptions}/man > ${descriptions}/man.gz DEPENDS ${descriptions}/man VERBATIM)
add_custom_target(ricochet_descriptions ALL
  DEPENDS ${descriptions}/man.gz ${descriptions}/bash ${descriptions}/zsh ${descriptions}/fish)
# ricochet_description(FORM FOLDER NAME): installs a form below the folder of data.
function(ricochet_description form folder name)
  install(FILES ${descriptions}/${form} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} RENAME ${name}
    OPTIONAL COMPONENT ricochet)
endfunction()
foreach(program ricochet ricochet-reproduce ricochet-studies)
  ricochet_description(man.gz man/man1 ${program}.1.gz)  # one manual for all
endforeach()
ricochet_description(bash bash-completion/completions ricochet)
ricochet_description(zsh zsh/vendor-completions _ricochet)
ricochet_description(fish fish/vendor_completions.d ricochet.fish)
ricochet_missing(ricochet ricochet_descriptions ${descriptions}/man.gz)
