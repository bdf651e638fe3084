# What the compiler is told last, whatever it was told before by CMAKE_CXX_FLAGS, by CMAKE_BUILD_TYPE or by the project
# that embeds the library: the bits of a result must not depend on that. strict_math.h and kernel/unit.h stop the build
# if it is told otherwise all the same. Each line is one option to CMake (SHELL:), which would else leave out of it what
# stands somewhere before.

include(CheckCXXCompilerFlag)

# Of -ffast-math and -Ofast every part undone; and what a compiler chooses to fuse is left apart. errno is not set, so
# that a square root is an instruction.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(MOTORWAY_STRICT_FLAGS "SHELL:-fno-fast-math -fno-unsafe-math-optimizations -fno-associative-math \
-fno-reciprocal-math -fno-finite-math-only -fsigned-zeros -fno-single-precision-constant -fno-math-errno \
-fno-allow-store-data-races -ffp-contract=off")
else()
  # -fno-fast-math would warn that it overrides.
  set(MOTORWAY_STRICT_FLAGS "SHELL:-fno-associative-math -fno-reciprocal-math -fno-approx-func -fno-finite-math-only \
-fhonor-nans -fhonor-infinities -fsigned-zeros -fno-rounding-math -fno-trapping-math -fdenormal-fp-math=ieee \
-fno-math-errno -ffp-contract=off")
endif()

# The instructions that every CPU of the architecture has, before those of a unit: no -march=native, no -mfma. GCC 12
# fuses even if it is told not to (PR 107647), where it vectorises and there is something to fuse with.
set(MOTORWAY_BASELINE_FLAGS "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|i[3-6]86)$")
  if(CMAKE_SIZEOF_VOID_P EQUAL 8)
    set(MOTORWAY_BASELINE_FLAGS "SHELL:-march=x86-64 -mno-sse3 -mfpmath=sse")
  else()
    set(MOTORWAY_BASELINE_FLAGS "SHELL:-msse2 -mno-sse3 -mfpmath=sse")
  endif()
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  set(MOTORWAY_BASELINE_FLAGS -fno-tree-vectorize)
endif()

# Link-time optimisation would compile once more, with flags of its own choice. A program in C links neither the
# assertions of the C++ library nor what its debug mode calls.
set(MOTORWAY_LIBRARY_FLAGS "SHELL:-fno-lto -fno-exceptions -fno-rtti -U_GLIBCXX_DEBUG -U_GLIBCXX_ASSERTIONS \
-D_GLIBCXX_NO_ASSERTIONS")

# Linked with -ffast-math or -Ofast, a shared library sets the whole process to take denormal numbers for zeros.
set(MOTORWAY_LINK_FLAGS "SHELL:-O2 -fno-lto -fno-fast-math -fno-unsafe-math-optimizations")
check_cxx_compiler_flag(-mno-daz-ftz MOTORWAY_HAS_DAZ_FTZ) # which does the same
if(MOTORWAY_HAS_DAZ_FTZ)
  string(APPEND MOTORWAY_LINK_FLAGS " -mno-daz-ftz")
endif()

# The instruction sets of this architecture, best first, and their flags.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|i[3-6]86)$")
  set(MOTORWAY_ISAS avx512 avx2 sse2 scalar)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
  set(MOTORWAY_ISAS neon64 scalar)
else()
  set(MOTORWAY_ISAS scalar)
endif()
set(MOTORWAY_FLAGS_avx512 "SHELL:-mavx512f -mavx512cd -mavx512bw -mavx512dq -mavx512vl -mfma \
-mprefer-vector-width=512")
set(MOTORWAY_FLAGS_avx2 "SHELL:-mavx2 -mfma")
# GCC copies vectors in memory by halves if it is not told otherwise, and loads of whole ones then wait for both stores.
check_cxx_compiler_flag("-mavx2 -mmove-max=256 -mstore-max=256" MOTORWAY_HAS_MOVE_MAX)
if(MOTORWAY_HAS_MOVE_MAX)
  string(APPEND MOTORWAY_FLAGS_avx2 " -mmove-max=256 -mstore-max=256")
endif()
set(MOTORWAY_FLAGS_sse2 -msse2)
set(MOTORWAY_FLAGS_neon64 "")
set(MOTORWAY_FLAGS_scalar "")

# A unit is optimised in a debug build too: without inlining, functions of the standard library would be emitted under
# its flags, and the linker could keep them for everyone.
set(MOTORWAY_UNIT_FLAGS -O3 -finline)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND MOTORWAY_UNIT_FLAGS -fno-keep-inline-functions)
endif()
