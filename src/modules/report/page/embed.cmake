# Puts the page's files into the program: included by CMake it adds the step, run by the build it writes the source.
if(CMAKE_SCRIPT_MODE_FILE)
  set(source "#include \"report/PageFiles.hpp\"\n\nnamespace naocal::pageFiles {\n\n")
  foreach(part page style script)
    string(APPEND source "const std::string_view ${part} =")
    foreach(file IN LISTS ${part})
      file(READ ${FOLDER}/${file} text)
      string(APPEND source "\n    R\"embedded(${text})embedded\"")
    endforeach()
    string(APPEND source ";\n\n")
  endforeach()
  file(WRITE ${OUTPUT} "${source}} // namespace naocal::pageFiles\n")
  return()
endif()

set(folder ${CMAKE_CURRENT_SOURCE_DIR}/report/page)
set(scripts data.js drawing.js estimates.js pictures.js fields.js trends.js groups.js main.js)
set(output ${CMAKE_CURRENT_BINARY_DIR}/report/PageFiles.cpp)
list(TRANSFORM scripts PREPEND ${folder}/ OUTPUT_VARIABLE scriptFiles)
add_custom_command(
  OUTPUT ${output}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DOUTPUT=${output} -Dpage=page.html -Dstyle=style.css "-Dscript=${scripts}"
          -P ${folder}/embed.cmake
  DEPENDS ${folder}/embed.cmake ${folder}/page.html ${folder}/style.css ${scriptFiles}
  VERBATIM)
target_sources(naocal_report PRIVATE ${output})
