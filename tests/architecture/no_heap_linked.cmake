# Refuses a linked program that holds a heap, exceptions or the machinery of static destructors: run as
#   cmake -DNM=nm -DPROGRAM=a.elf -P no_heap_linked.cmake
set(forbidden
  "^_?_?(malloc|calloc|realloc|free|memalign)(_r)?$" "^_?sbrk(_r)?$"
  "^_Zn[aw]" "^_Zd[al]"                                        # operator new and delete
  "^__cxa_(throw|rethrow|allocate_exception|guard_|atexit|pure_virtual)" "^__aeabi_(atexit|unwind)" "^_Unwind_"
  "^_?v?s?n?printf(_r)?$")
execute_process(COMMAND ${NM} --format=posix ${PROGRAM} OUTPUT_VARIABLE listing RESULT_VARIABLE failed)
if(failed OR listing STREQUAL "")
  message(FATAL_ERROR "${NM} finds no symbols in ${PROGRAM}")
endif()
string(REGEX MATCHALL "[^\n]+" rows "${listing}")
foreach(row IN LISTS rows)
  string(REGEX REPLACE " .*" "" symbol "${row}")
  foreach(pattern IN LISTS forbidden)
    if(symbol MATCHES "${pattern}")
      message(SEND_ERROR "linked in: ${symbol}")
    endif()
  endforeach()
endforeach()
