# Refuses archives that need more than the firmware may: run as
#   cmake -DNM=nm -DCXXFILT=c++filt "-DARCHIVES=a.a;b.a" -P forbidden_symbols.cmake
#
# The archives may use each other and the short list below. Everything else is an error, so that a heap, an
# exception, a guarded static, libm or a print cannot come in under a name that nobody thought of.
set(allowed
  memcpy memmove memset memcmp        # the compiler writes these itself
  __memcpy_chk __memmove_chk __memset_chk __stack_chk_fail  # and these where a distribution hardens its code
  sqrt sqrtf                          # correctly rounded by IEEE 754, unlike the rest of libm
  _GLOBAL_OFFSET_TABLE_)
set(allowed_patterns
  "^__aeabi_u?[dfil](2|add|sub|rsub|mul|div|cmp|ls|as)[a-z0-9]*$"  # arithmetic that the processor lacks (ARM)
  "^__aeabi_mem(cpy|move|set|clr)[48]?$"
  "^__[a-z]+[sdt][if][23]$")          # the same by libgcc's other names, such as __divdi3

function(symbols_of archive out)
  execute_process(COMMAND ${NM} ${ARGN} ${archive}
    OUTPUT_VARIABLE listing ERROR_VARIABLE error RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${NM} cannot read ${archive}: ${error}")
  endif()
  string(REGEX MATCHALL "[A-Za-z] [A-Za-z0-9_.$]+\n" rows "${listing}")
  list(TRANSFORM rows REPLACE "^. (.*)\n" "\\1")
  set(${out} ${rows} PARENT_SCOPE)
endfunction()

set(needed "")
set(offered ${allowed})
foreach(archive IN LISTS ARCHIVES)
  symbols_of(${archive} more_needed --undefined-only)
  symbols_of(${archive} more_offered --defined-only)
  list(APPEND needed ${more_needed})
  list(APPEND offered ${more_offered})
endforeach()
if(needed STREQUAL "" AND offered STREQUAL "${allowed}")
  message(FATAL_ERROR "no symbols at all in ${ARCHIVES}")
endif()

list(REMOVE_DUPLICATES needed)
list(REMOVE_ITEM needed ${offered})
foreach(pattern IN LISTS allowed_patterns)
  list(FILTER needed EXCLUDE REGEX "${pattern}")
endforeach()
list(SORT needed)
foreach(symbol IN LISTS needed)
  execute_process(COMMAND ${CXXFILT} ${symbol} OUTPUT_VARIABLE name OUTPUT_STRIP_TRAILING_WHITESPACE)
  message(SEND_ERROR "forbidden symbol: ${name}")
endforeach()
