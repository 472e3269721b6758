# ricochet_embed(TARGET FILE NAME): makes the text of FILE available to TARGET as
# ricochet::embedded::NAME, declared in embedded/NAME.h.
function(ricochet_embed target file name)
  file(READ ${file} text)
  ricochet_embed_text(${target} ${file} ${name} "${text}")
endfunction()

# ricochet_embed_base64(TARGET FILE NAME): the same for the bytes of FILE, in base64.
function(ricochet_embed_base64 target file name)
  execute_process(COMMAND base64 -w 0 ${file} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  ricochet_embed_text(${target} ${file} ${name} "${text}")
endfunction()

function(ricochet_embed_text target file name text)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  set(EMBEDDED_NAME ${name})
  set(EMBEDDED_TEXT "${text}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded.h.in
                 ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.h @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()

# ricochet_embed_list(TARGET LIST NAME=FILE...): makes the texts of the files available to TARGET, in this order,
# as ricochet::embedded::LIST, pairs of name and text, declared in embedded/LIST.h.
function(ricochet_embed_list target list)
  set(headers "#include <utility>\n\n")
  set(rows "")
  foreach(entry ${ARGN})
    string(REGEX MATCH "^([^=]*)=(.*)$" entry ${entry})
    set(name ${CMAKE_MATCH_1})
    set(file ${CMAKE_MATCH_2})
    string(MAKE_C_IDENTIFIER "${list}_${name}" identifier)
    ricochet_embed(${target} ${file} ${identifier})
    string(APPEND headers "#include \"embedded/${identifier}.h\"\n")
    string(APPEND rows "    {\"${name}\", ${identifier}},\n")
  endforeach()
  file(CONFIGURE OUTPUT embedded/${list}.h @ONLY CONTENT "#pragma once

@headers@
namespace ricochet::embedded {

inline constexpr std::pair<const char*, const char*> ${list}[] = {
@rows@};

}  // namespace ricochet::embedded
")
endfunction()
