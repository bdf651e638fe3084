# cmake -Dnm=NM -Dlibrary=libmotorway.a -Dobjects=a.o;b.o -P calls_all.cmake
#
# The objects call every function that the library defines: what is new has to be added to them. Of functions that take
# arrays by pointers and strides, or views, those of views: the others hand the same to the same (tests/plain_test.cpp).

cmake_minimum_required(VERSION 3.16)

function(symbols_of out letter)
  execute_process(COMMAND ${nm} -P ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE ignored RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${nm} cannot read ${ARGN}")
  endif()
  string(REGEX MATCHALL "mw_[a-z0-9_]+ ${letter}" found "${output}")
  list(TRANSFORM found REPLACE " .*" "")
  list(REMOVE_DUPLICATES found)
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

if(library MATCHES "\\.a$")
  symbols_of(defined T ${library})
else()
  symbols_of(defined T -D ${library})
endif()
symbols_of(called U ${objects})
list(LENGTH defined count)
if(count EQUAL 0)
  message(FATAL_ERROR "${library} defines no function of the library")
endif()
set(of_views ${defined})
list(FILTER of_views INCLUDE REGEX "_views(_|$)")
list(TRANSFORM of_views REPLACE "_views" "")
list(REMOVE_ITEM defined ${called} ${of_views})
if(defined)
  list(JOIN defined "\n    " text)
  message(FATAL_ERROR "memcheck does not call\n    ${text}\nAdd them to tests/fuzz or to tests/memcheck.")
endif()
message("all of ${count} functions are called")
