# The worst-case stack of the loop, from the compiler's own call graph of the objects that are linked: GCC only.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  message(STATUS "The worst-case stack is computed in builds with GCC only")
  return()
endif()
foreach(target articam_core articam_firmware)
  target_compile_options(${target} PRIVATE -fcallgraph-info=su,da)
  set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "")  # compiler caches forget the graphs
  get_target_property(folder ${target} BINARY_DIR)
  list(APPEND graphs ${folder}/CMakeFiles/${target}.dir)
endforeach()
# What this folder compiled before, for models that it no longer has, would be measured too.
get_target_property(sources articam_firmware SOURCES)
get_target_property(folder articam_firmware BINARY_DIR)
file(GLOB compiled ${folder}/CMakeFiles/articam_firmware.dir/firmware_*.cpp.*)
foreach(file IN LISTS compiled)
  string(REGEX REPLACE ".*/(firmware_.*\\.cpp)\\..*" "\\1" source ${file})
  if(NOT ${folder}/${source} IN_LIST sources)
    file(REMOVE ${file})
  endif()
endforeach()

if(CMAKE_SYSTEM_NAME STREQUAL "Generic")
  articam_add_host_program(articam-stack SOURCES call_graph.cpp stack_main.cpp)
  set(program ${articam-stack})
else()
  add_executable(articam-stack call_graph.cpp stack_main.cpp)
  target_include_directories(articam-stack PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(articam-stack PRIVATE articam::strict)
  set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:articam-stack>)
endif()

if(NOT DEFINED ARTICAM_TARGET_NAME)
  set(ARTICAM_TARGET_NAME ${CMAKE_SYSTEM_PROCESSOR})
endif()

# articam_add_ceiling_test(NAME GROUP regex CEILINGS file COMMAND program argument ...): see hold_ceilings.cmake.
function(articam_add_ceiling_test name)
  cmake_parse_arguments(arg "" "GROUP;CEILINGS" "COMMAND" ${ARGN})
  string(MAKE_C_IDENTIFIER ${name} file)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} "-DCOMMAND=${arg_COMMAND}" -DTARGET=${ARTICAM_TARGET_NAME}
    -DGROUP=${arg_GROUP} -DCEILINGS=${arg_CEILINGS} -DTABLE=${PROJECT_BINARY_DIR}/${file}.txt
    -P ${PROJECT_SOURCE_DIR}/tests/architecture/hold_ceilings.cmake)
endfunction()

# Other versions of GCC and other build types spend other frames: there the rules hold, the ceilings do not.
set(ceilings ${PROJECT_SOURCE_DIR}/tests/board/ceilings.txt)
file(STRINGS ${ceilings} rows REGEX "^${ARTICAM_TARGET_NAME} ")
if(rows AND CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^12\\.")
  set(group loop_stack_bytes)
  if(ARTICAM_FIRMWARE_MODELS)
    list(JOIN ARTICAM_FIRMWARE_MODELS "|" models)
    string(APPEND group "/(${models})/")
  endif()
  articam_add_ceiling_test(Stack.OfTheLoopIsBoundedAndUnderItsCeilingForEveryModel GROUP ${group}
    CEILINGS ${ceilings} COMMAND ${program} ${graphs})
else()
  add_test(NAME Stack.OfTheLoopIsBounded COMMAND ${program} ${graphs})
endif()

# The check of the ceilings itself, on a program that prints the figure 11.
foreach(planted "AValueUnderItsCeilingPasses:12:planted 11 ceiling 12" "AValueOverItsCeilingIsFound:10:planted is 11"
    "AValueWithoutACeilingIsFound::its ceiling none")
  string(REGEX MATCH "^(.*):(.*):(.*)$" matched ${planted})
  set(name Ceilings.${CMAKE_MATCH_1})
  set(expected ${CMAKE_MATCH_3})
  set(file ${CMAKE_CURRENT_BINARY_DIR}/planted_${CMAKE_MATCH_1}.txt)
  if(CMAKE_MATCH_2)
    file(CONFIGURE OUTPUT ${file} CONTENT "${ARTICAM_TARGET_NAME} planted ${CMAKE_MATCH_2}\n")
  else()
    file(CONFIGURE OUTPUT ${file} CONTENT "\n")
  endif()
  articam_add_ceiling_test(${name} GROUP planted CEILINGS ${file} COMMAND echo "planted 11")
  set_tests_properties(${name} PROPERTIES PASS_REGULAR_EXPRESSION ${expected})
endforeach()
