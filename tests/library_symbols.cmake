# cmake -Dnm=NM -Dlibrary=libmotorway.a -Dapi=generated/api.json -P library_symbols.cmake
#
# The library has the functions of the table, and no other of its prefix.
#
# A program in C links the static library with nothing but the C library: no libm, no C++ library. So no object may
# need a symbol that is neither in the library nor one of these.

cmake_minimum_required(VERSION 3.22)

# The C library's; what compilers call on their own; and the CPU's features and atomic instructions, from the compiler's
# own static library.
set(allowed "^(memcpy|memmove|memset|memcmp|strcmp|getenv|__stack_chk_fail|_GLOBAL_OFFSET_TABLE_|__cpu_model|\
__aarch64_.*|__gcov_.*|__llvm_.*)$")

execute_process(COMMAND ${nm} -P ${library} OUTPUT_VARIABLE output RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${nm} cannot read ${library}")
endif()
string(REPLACE ";" "" output "${output}")
string(REPLACE "\n" ";" lines "${output}")
set(defined "")
set(needed "")
set(object "")
set(failures "")
foreach(line IN LISTS lines)
  if(line MATCHES "\\[(.*)\\]:$")
    set(object ${CMAKE_MATCH_1})
  elseif(line MATCHES "^([^ ]+) U")
    list(APPEND needed ${CMAKE_MATCH_1})
    list(APPEND needed_by_${CMAKE_MATCH_1} ${object})
  elseif(line MATCHES "^([^ ]+) [A-TV-Z]")
    list(APPEND defined ${CMAKE_MATCH_1})
  endif()
endforeach()
if(NOT "mw_isa" IN_LIST defined)
  message(FATAL_ERROR "${library} does not define mw_isa: what was read is not the library")
endif()
list(REMOVE_DUPLICATES needed)
foreach(symbol IN LISTS needed)
  if(NOT symbol IN_LIST defined AND NOT symbol MATCHES "${allowed}")
    list(JOIN needed_by_${symbol} ", " objects)
    list(APPEND failures "${symbol}, by ${objects}")
  endif()
endforeach()
if(failures)
  list(JOIN failures "\n  " text)
  message(FATAL_ERROR "The library needs what a program in C does not link:\n  ${text}")
endif()

file(READ ${api} functions)
string(JSON last LENGTH "${functions}")
math(EXPR last "${last} - 1")
set(expected "")
foreach(k RANGE ${last})
  string(JSON name GET "${functions}" ${k} name)
  list(APPEND expected ${name})
endforeach()
list(FILTER defined INCLUDE REGEX "^mw_")
set(missing ${expected})
list(REMOVE_ITEM missing ${defined})
list(REMOVE_ITEM defined ${expected})
if(missing OR defined)
  message(FATAL_ERROR "${api} has what the library lacks: ${missing}; and lacks what it has: ${defined}")
endif()

list(LENGTH needed count)
message(STATUS "${count} symbols needed, all of them in the library or in the C library")
