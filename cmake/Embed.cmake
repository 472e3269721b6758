# ricochet_embed(TARGET FILE NAME): makes the text of FILE available to TARGET as
# ricochet::embedded::NAME, declared in embedded/NAME.h.
function(ricochet_embed target file name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} EMBEDDED_TEXT)
  set(EMBEDDED_NAME ${name})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded.h.in
                 ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.h @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
