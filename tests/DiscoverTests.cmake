# Writes a CTest file with all test cases of a Catch2 program. Each has one label: that of its tag ([slow], [robot] or
# [browser]), else `fast`. Hidden test cases ([.]) are excluded. Runs after linking:
#   cmake -D PROGRAM=... -D FOLDER=... -D FILE=... -P DiscoverTests.cmake
set(tags slow robot browser)
set(script "")
set(count 0)

# Lists the test cases of a test specification and labels them.
function(add_labelled label specification)
  execute_process(COMMAND ${PROGRAM} ${specification} --list-test-names-only OUTPUT_VARIABLE names RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(NOT result MATCHES "^[0-9]+$") # the exit code is the number of test cases
    message(FATAL_ERROR "${PROGRAM} cannot list its tests: ${result}\n${errors}")
  endif()
  set(cost 10) # what takes long starts first
  if(label STREQUAL fast)
    set(cost 0)
  endif()
  string(REGEX REPLACE "\n+$" "" names "${names}")
  string(REPLACE ";" "\\;" names "${names}")
  string(REPLACE "\n" ";" names "${names}")
  foreach(name IN LISTS names)
    string(REGEX REPLACE "([][,])" "\\\\\\1" argument "${name}")
    string(APPEND script "add_test([==[${FOLDER}: ${name}]==] [==[${PROGRAM}]==] [==[${argument}]==])\n"
      "set_tests_properties([==[${FOLDER}: ${name}]==] PROPERTIES LABELS ${label} COST ${cost} SKIP_RETURN_CODE 77)\n")
    math(EXPR count "${count} + 1")
  endforeach()
  set(script "${script}" PARENT_SCOPE)
  set(count ${count} PARENT_SCOPE)
endfunction()

set(others "")
foreach(tag IN LISTS tags)
  add_labelled(${tag} "[${tag}]~[.]")
  string(APPEND others "~[${tag}]")
endforeach()
add_labelled(fast "${others}~[.]")
if(count EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} has no tests")
endif()
file(WRITE "${FILE}" "${script}")
