// Stops the build where the compiler was told to compute something else than what is written. What the library
// promises of NaN, of signs of zeros and of equal bits would be lost in silence.
#pragma once

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                        \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) ||                    \
    defined(_M_FP_FAST)
#error "Motorway must not be compiled with -ffast-math, -Ofast or a part of them (/fp:fast). Its CMakeLists.txt appends \
the flags that undo them (src/flags.cmake); in another build system, append these yourself or leave -ffast-math out."
#endif
