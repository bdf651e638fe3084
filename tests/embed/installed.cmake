# cmake -Dbuild=DIR -Dwork=DIR -Dtests=DIR -Dc_compiler=CC -Dpkg_config=COMMAND -P installed.cmake
#
# Installs a build, moves what was installed elsewhere, as packagers and users do, and builds and runs programs in C
# against it: by find_package, and with the flags that pkg-config says.

cmake_minimum_required(VERSION 3.22)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${work} RESULT_VARIABLE failed OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(failed)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}:\n${output}")
  endif()
endfunction()

set(prefix "${work}/moved here")
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/installed)
file(RENAME ${work}/installed ${prefix})
file(GLOB_RECURSE description ${prefix}/*/motorway.pc)
get_filename_component(pkgconfig_folder ${description} DIRECTORY)

run(${CMAKE_COMMAND} -S ${tests}/embed/c -B found -DCMAKE_PREFIX_PATH=${prefix} -DMOTORWAY_TESTS=${tests}
    -DCMAKE_C_COMPILER=${c_compiler} -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build found)
run(${CMAKE_CTEST_COMMAND} --test-dir found --output-on-failure)
message(STATUS "find_package works")

if(NOT pkg_config)
  message(STATUS "pkg-config was not found, and is not tested")
  return()
endif()
set(ENV{PKG_CONFIG_PATH} ${pkgconfig_folder})
run(${pkg_config} --exact-version=${version} motorway)
run(sh -c "eval \"${c_compiler} -std=c99 ${tests}/c99_test.c $(${pkg_config} --cflags --libs motorway) -o by_flags\"")
get_filename_component(library_folder ${pkgconfig_folder} DIRECTORY)
set(ENV{LD_LIBRARY_PATH} ${library_folder})
run(${work}/by_flags)
message(STATUS "pkg-config works")
