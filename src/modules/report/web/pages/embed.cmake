# Puts the pages' files into the program: included by CMake it adds the step, run by the build it writes the source.
# Scripts stay ES modules, letter by letter: a page carries all of web/lib, web/plots, web/views and web/pages in an import
# map, as data: addresses under the names by which they import each other ("naocal/lib/figure.js"). This needs neither npm
# nor a network, and a page opens from a file. The panel's build gives the same names to esbuild.
set(web ${CMAKE_CURRENT_LIST_DIR}/..)
set(style lib/palette.css lib/views.css pages/style.css)
set(result_style ${style})
set(diagnosis_style ${style} pages/diagnosis.css)
set(evaluation_style ${style} pages/evaluation.css)

# A file's text in `variable`, as a C++ literal.
function(read_literal variable file)
  file(READ ${web}/${file} text)
  set(${variable} "\n    R\"embedded(${text})embedded\"" PARENT_SCOPE)
endfunction()

# A script as one entry of the import map; letters that would end the address, the JSON or the element are escaped.
function(read_module variable file)
  file(READ ${web}/${file} text)
  string(APPEND text "//# sourceURL=naocal/${file}\n")
  string(REPLACE "%" "%25" text "${text}")
  string(REPLACE "\\" "%5C" text "${text}")
  string(REPLACE "\"" "%22" text "${text}")
  string(REPLACE "#" "%23" text "${text}")
  string(REPLACE "<" "%3C" text "${text}")
  string(REPLACE "\t" "%09" text "${text}")
  string(REPLACE "\n" "%0A" text "${text}")
  set(${variable} "\n    R\"embedded(\"naocal/${file}\":\"data:text/javascript;charset=utf-8,${text}\")embedded\"" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  set(source "#include \"report/PageFiles.hpp\"\n\nnamespace naocal::pageFiles {\n\n")
  read_literal(text pages/frame.html)
  string(APPEND source "const std::string_view frame =${text};\n\nnamespace {\nconst std::string_view list[] = {")
  file(GLOB files RELATIVE ${web} ${web}/lib/*.js ${web}/plots/*.js ${web}/views/*.js ${web}/pages/*.js)
  foreach(file IN LISTS files)
    read_module(text ${file})
    string(APPEND source "${text},")
  endforeach()
  string(APPEND source "};\n} // namespace\n\nconst std::span<const std::string_view> modules = list;\n\n")
  foreach(page result diagnosis evaluation)
    read_literal(sections pages/${page}.html)
    string(APPEND source "const Page ${page}{\n  .name = \"${page}\",\n  .sections =${sections},\n  .style =")
    foreach(file IN LISTS ${page}_style)
      read_literal(text ${file})
      string(APPEND source "${text}")
    endforeach()
    string(APPEND source "};\n\n")
  endforeach()
  file(WRITE ${OUTPUT} "${source}} // namespace naocal::pageFiles\n")
  return()
endif()

set(output ${CMAKE_CURRENT_BINARY_DIR}/report/PageFiles.cpp)
file(GLOB files CONFIGURE_DEPENDS ${web}/lib/*.js ${web}/lib/*.css ${web}/plots/*.js ${web}/views/*.js ${web}/pages/*.js ${web}/pages/*.html ${web}/pages/*.css)
add_custom_command(
  OUTPUT ${output}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -P ${CMAKE_CURRENT_LIST_DIR}/embed.cmake
  DEPENDS ${CMAKE_CURRENT_LIST_DIR}/embed.cmake ${files}
  VERBATIM)
target_sources(naocal_report PRIVATE ${output})
# Compiled by itself: a change of a view compiles nothing else.
set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
