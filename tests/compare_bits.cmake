# cmake -Dprogram=FILE "-Dobjects=a.o;b.o" -Dlibrary=FILE "-Dlink=c++;-lgtest" "-Disas=avx2;scalar" -Dwork=DIR
#       -P compare_bits.cmake
#
# Whatever flags a library was compiled with, its results are the same to the last bit: links the objects of bits_print
# with the given library, and compares what that and `program`, which is linked with another, print.

cmake_minimum_required(VERSION 3.22)
file(MAKE_DIRECTORY ${work})
get_filename_component(library_folder ${library} DIRECTORY)
list(GET link 0 compiler)
list(REMOVE_AT link 0)
execute_process(COMMAND ${compiler} ${objects} ${library} ${link} -Wl,-rpath,${library_folder} -o ${work}/bits_print
                RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "bits_print could not be linked with ${library}")
endif()

set(compared "")
foreach(isa IN LISTS isas)
  set(ENV{MOTORWAY_ISA} ${isa})
  execute_process(COMMAND ${program} OUTPUT_VARIABLE expected RESULT_VARIABLE failed ERROR_VARIABLE error)
  if(failed)
    message(STATUS "${isa} is not compared: ${error}")
    continue()
  endif()
  execute_process(COMMAND ${work}/bits_print OUTPUT_VARIABLE printed RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${work}/bits_print failed on ${isa}")
  endif()
  if(NOT printed STREQUAL expected)
    string(REPLACE "\n" ";" expected "${expected}")
    string(REPLACE "\n" ";" printed "${printed}")
    list(REMOVE_ITEM printed ${expected})
    list(JOIN printed "\n  " differences)
    message(FATAL_ERROR "On ${isa} ${library} computes something else:\n  ${differences}")
  endif()
  list(APPEND compared ${isa})
endforeach()
if(NOT compared)
  message(FATAL_ERROR "None of ${isas} could be compared")
endif()
list(JOIN compared ", " compared)
message(STATUS "the same bits on ${compared}")
