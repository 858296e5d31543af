# Runs a program and holds its text against a file, line by line:
#   cmake "-DCOMMAND=program;argument" -DEXPECTED=expected.txt -DFLOAT_ONLY=OFF -P compare.cmake
# FLOAT_ONLY leaves out what double has computed; README.md says where, and why.
execute_process(COMMAND ${COMMAND} OUTPUT_VARIABLE text ERROR_VARIABLE error RESULT_VARIABLE failed TIMEOUT 600)
if(failed)
  message(FATAL_ERROR "${COMMAND}: ${failed}\n${text}${error}")
endif()
file(READ ${EXPECTED} expected)
if(FLOAT_ONLY)
  foreach(variable text expected)
    string(REGEX REPLACE " double [0-9a-f]+ [0-9a-f]+" "" ${variable} "${${variable}}")
    string(REGEX REPLACE "(detections [0-9]+) [0-9]+" "\\1" ${variable} "${${variable}}")
  endforeach()
endif()
if(text STREQUAL expected)
  return()
endif()
string(REPLACE "\n" ";" lines "${text}")
string(REPLACE "\n" ";" expected_lines "${expected}")
foreach(line expected IN ZIP_LISTS lines expected_lines)
  if(NOT line STREQUAL expected)
    string(REGEX MATCH "^frame [0-9]+|^" name "${line}")
    message(FATAL_ERROR "${name} differs first:\n  here      ${line}\n  expected  ${expected}\n"
      "Other pixels: the drawing differs, see tests/bits/scene.cpp. Other detections: the detector. Only the last\n"
      "number of a scalar: the estimator. If the change is meant, run articam-bits on two machines, compare, and\n"
      "write its text to ${EXPECTED}.")
  endif()
endforeach()
message(FATAL_ERROR "the last line differs")
