# Puts the pages' files into the program: included by CMake it adds the step, run by the build it writes the source.
# What stands in shared/ is drawn in the panel's page too, which imports it as modules; here files are one script, as
# which they need neither `import` nor `export`, nor npm.
set(result_sections result.html)
set(result_style style.css)
set(shared shared/words.js shared/figure.js shared/axes.js shared/plots.js)
set(result_script ${shared} basics.js data.js drawing.js estimates.js pictures.js fields.js trends.js groups.js result.js)
set(evaluation_sections evaluation.html)
set(evaluation_style style.css evaluation.css)
set(evaluation_script ${shared} basics.js drawing.js evaluation.js)
set(diagnosis_sections diagnosis.html)
set(diagnosis_style style.css diagnosis.css)
set(diagnosis_script ${shared} shared/taken.js shared/deflections.js shared/within.js shared/boards.js basics.js
  drawing.js ladder.js candidates.js taken.js added.js aliases.js imprint.js map.js curves.js whatif.js within.js shapes.js
  diagnosis.js)

if(CMAKE_SCRIPT_MODE_FILE)
  set(source "#include \"report/PageFiles.hpp\"\n\nnamespace naocal::pageFiles {\n\n")
  file(READ ${CMAKE_CURRENT_LIST_DIR}/frame.html text)
  string(APPEND source "const std::string_view frame = R\"embedded(${text})embedded\";\n\n")
  foreach(page result diagnosis evaluation)
    string(APPEND source "const Page ${page}{")
    foreach(part sections style script)
      string(APPEND source "\n  .${part} =")
      foreach(file IN LISTS ${page}_${part})
        file(READ ${CMAKE_CURRENT_LIST_DIR}/${file} text)
        if(part STREQUAL "script")
          string(REGEX REPLACE "(^|\n)import [^\n]*" "" text "${text}")
          string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
        endif()
        string(APPEND source "\n    R\"embedded(${text})embedded\"")
      endforeach()
      string(APPEND source ",")
    endforeach()
    string(APPEND source "};\n\n")
  endforeach()
  file(WRITE ${OUTPUT} "${source}} // namespace naocal::pageFiles\n")
  return()
endif()

set(folder ${CMAKE_CURRENT_SOURCE_DIR}/report/page)
set(output ${CMAKE_CURRENT_BINARY_DIR}/report/PageFiles.cpp)
file(GLOB files CONFIGURE_DEPENDS ${folder}/*.html ${folder}/*.css ${folder}/*.js ${folder}/shared/*.js)
add_custom_command(
  OUTPUT ${output}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -P ${folder}/embed.cmake
  DEPENDS ${folder}/embed.cmake ${files}
  VERBATIM)
target_sources(naocal_report PRIVATE ${output})
