# Builds the panel's page and puts it into the program: included by CMake it adds the step, run by the build it does it.
# Needs npm, and once a registry that it reaches; without them the program says in a sentence that it has no page.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  find_program(NPM npm)
  set(page_folder ${CMAKE_CURRENT_SOURCE_DIR}/page)
  set(page_output ${CMAKE_CURRENT_BINARY_DIR}/page/Page.cpp)
  if(EXISTS ${page_output}.missing)
    file(REMOVE ${page_output}) # to be tried again
  endif()
  set(page_web ${CMAKE_SOURCE_DIR}/src/modules/report/web) # what report and panel draw alike, imported as naocal/...
  file(GLOB_RECURSE page_files CONFIGURE_DEPENDS ${page_folder}/*.js ${page_folder}/*.css ${page_folder}/*.html
    ${page_web}/lib/*.js ${page_web}/lib/*.css ${page_web}/plots/*.js ${page_web}/views/*.js)
  set(page_glossary ${CMAKE_SOURCE_DIR}/docs/glossary.md) # the panel explains terms in its words
  add_custom_command(
    OUTPUT ${page_output}
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DOUTPUT=${page_output} -DSOURCE=${page_folder} -DWEB=${page_web} -P ${page_folder}/build.cmake
    DEPENDS ${page_folder}/build.cmake ${page_folder}/package.json ${page_folder}/package-lock.json ${page_glossary} ${page_files}
    COMMENT "Building the panel's page"
    VERBATIM)
  add_library(mate_bridge_page OBJECT ${page_output})
  target_include_directories(mate_bridge_page PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(mate_bridge PUBLIC mate_bridge_page)
  return()
endif()

get_filename_component(folder ${OUTPUT} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
file(REMOVE ${OUTPUT}.missing)
set(missing "")

# node_modules of the lock file, kept as long as that stays the same.
file(SHA256 ${SOURCE}/package-lock.json lock)
set(have "")
if(EXISTS ${folder}/installed)
  file(READ ${folder}/installed have)
endif()
if(NOT NPM)
  set(missing "npm is not installed")
elseif(NOT have STREQUAL lock)
  foreach(file package.json package-lock.json .npmrc)
    configure_file(${SOURCE}/${file} ${folder}/${file} COPYONLY)
  endforeach()
  execute_process(
    COMMAND ${NPM} ci --prefer-offline --no-audit --no-fund --ignore-scripts --loglevel=error --fetch-retries=1 --fetch-timeout=30000
    WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE words TIMEOUT 180)
  if(failed)
    string(REGEX REPLACE "\n.*" "" words "${words}")
    set(missing "npm could not get its packages (${words})")
  else()
    file(WRITE ${folder}/installed ${lock})
  endif()
endif()
if(missing STREQUAL "")
  set(ENV{NODE_PATH} ${folder}/node_modules)
  execute_process(
    COMMAND ${folder}/node_modules/.bin/esbuild ${SOURCE}/panel.js ${SOURCE}/panel.css --bundle --minify --format=iife --alias:naocal=${WEB} --loader:.md=text
            --target=chrome123,firefox120,safari17.5 --outdir=${folder} --log-level=warning --legal-comments=inline
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "esbuild does not accept the page's sources")
  endif()
endif()

# The source: a list of files, or the sentence.
set(list "")
if(missing STREQUAL "")
  file(WRITE ${folder}/licences.txt "")
  foreach(package uplot svgcanvas)
    file(READ ${folder}/node_modules/${package}/LICENSE text)
    file(APPEND ${folder}/licences.txt "${package}\n\n${text}\n\n")
  endforeach()
  file(COPY_FILE ${SOURCE}/index.html ${folder}/index.html)
  foreach(entry "index.html text/html" "panel.js text/javascript" "panel.css text/css" "licences.txt text/plain")
    separate_arguments(entry)
    list(GET entry 0 name)
    list(GET entry 1 type)
    file(READ ${folder}/${name} text)
    string(LENGTH "${text}" length)
    set(pieces "") # compilers need not take longer literals than 64 KiB
    set(at 0)
    while(at LESS length)
      string(SUBSTRING "${text}" ${at} 15000 piece)
      string(APPEND pieces "\n    R\"embedded(${piece})embedded\"")
      math(EXPR at "${at} + 15000")
    endwhile()
    string(APPEND list "  if (name == \"${name}\") {\n    return PageFile{\"${type}; charset=utf-8\",${pieces}};\n  }\n")
  endforeach()
else()
  set(missing "The panel's page is not built into this program: ${missing}; see to it, then run cmake and build again.")
  message("${missing}")
  file(WRITE ${OUTPUT}.missing "${missing}")
endif()
file(WRITE ${OUTPUT} "#include \"server/PageFiles.hpp\"

namespace naocal {

std::optional<PageFile> pageFile([[maybe_unused]] std::string_view name) {
${list}  return std::nullopt;
}

std::string_view pageMissing() {
  return R\"embedded(${missing})embedded\";
}

} // namespace naocal
")
