// Vectors of one instruction set. The only file that names xsimd or an intrinsic.
//
// A unit defines MOTORWAY_ISA_<name> and includes this once. xsimd is put into a namespace of the unit's own:
// its inline functions are compiled with the unit's flags, and the linker would otherwise keep one copy for all.
#pragma once

#include <cstddef>
#include <utility>

#if defined(MOTORWAY_ISA_scalar)
#define MOTORWAY_ISA_NAME scalar
#else
#if defined(MOTORWAY_ISA_sse2)
#define MOTORWAY_ISA_NAME sse2
#define xsimd motorway_xsimd_sse2
#elif defined(MOTORWAY_ISA_avx2)
#define MOTORWAY_ISA_NAME avx2
#define xsimd motorway_xsimd_avx2
#elif defined(MOTORWAY_ISA_avx512)
#define MOTORWAY_ISA_NAME avx512
#define xsimd motorway_xsimd_avx512
#elif defined(MOTORWAY_ISA_neon64)
#define MOTORWAY_ISA_NAME neon64
#define xsimd motorway_xsimd_neon64
#endif
#include <xsimd/xsimd.hpp>
#endif

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

#if defined(MOTORWAY_ISA_scalar)
template <class T> using vector = T;
#else
#if defined(MOTORWAY_ISA_sse2)
using architecture = xsimd::sse2;
#elif defined(MOTORWAY_ISA_avx2)
using architecture = xsimd::fma3<xsimd::avx2>;
#elif defined(MOTORWAY_ISA_avx512)
using architecture = xsimd::avx512bw;
#elif defined(MOTORWAY_ISA_neon64)
using architecture = xsimd::neon64;
#endif
template <class T> using vector = xsimd::batch<T, architecture>;
#endif

// The number of lanes.
template <class T> constexpr int width = static_cast<int>(sizeof(vector<T>) / sizeof(T));

// ------------------------------------------------------------------------------------------------- arithmetic

// a b + c, c - a b and a b - c: one rounding where the instruction set fuses, two where it does not. Square roots
// and the four operations are xsimd's.
#if defined(MOTORWAY_ISA_scalar) || defined(MOTORWAY_ISA_sse2)
template <class V> inline V fma(const V &a, const V &b, const V &c) { return a * b + c; }
template <class V> inline V fnma(const V &a, const V &b, const V &c) { return c - a * b; }
template <class V> inline V fms(const V &a, const V &b, const V &c) { return a * b - c; }
#else
inline float fma(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
inline double fma(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline float fnma(float a, float b, float c) { return __builtin_fmaf(-a, b, c); }
inline double fnma(double a, double b, double c) { return __builtin_fma(-a, b, c); }
inline float fms(float a, float b, float c) { return __builtin_fmaf(a, b, -c); }
inline double fms(double a, double b, double c) { return __builtin_fma(a, b, -c); }

using floats = vector<float>;
using doubles = vector<double>;
#if defined(MOTORWAY_ISA_avx512) // xsimd 8.1 does not fuse here
inline floats fma(const floats &a, const floats &b, const floats &c) { return _mm512_fmadd_ps(a, b, c); }
inline floats fnma(const floats &a, const floats &b, const floats &c) { return _mm512_fnmadd_ps(a, b, c); }
inline floats fms(const floats &a, const floats &b, const floats &c) { return _mm512_fmsub_ps(a, b, c); }
inline doubles fma(const doubles &a, const doubles &b, const doubles &c) { return _mm512_fmadd_pd(a, b, c); }
inline doubles fnma(const doubles &a, const doubles &b, const doubles &c) { return _mm512_fnmadd_pd(a, b, c); }
inline doubles fms(const doubles &a, const doubles &b, const doubles &c) { return _mm512_fmsub_pd(a, b, c); }
#elif defined(MOTORWAY_ISA_avx2)
inline floats fma(const floats &a, const floats &b, const floats &c) { return _mm256_fmadd_ps(a, b, c); }
inline floats fnma(const floats &a, const floats &b, const floats &c) { return _mm256_fnmadd_ps(a, b, c); }
inline floats fms(const floats &a, const floats &b, const floats &c) { return _mm256_fmsub_ps(a, b, c); }
inline doubles fma(const doubles &a, const doubles &b, const doubles &c) { return _mm256_fmadd_pd(a, b, c); }
inline doubles fnma(const doubles &a, const doubles &b, const doubles &c) { return _mm256_fnmadd_pd(a, b, c); }
inline doubles fms(const doubles &a, const doubles &b, const doubles &c) { return _mm256_fmsub_pd(a, b, c); }
#elif defined(MOTORWAY_ISA_neon64) // the accumulator comes first
inline floats fma(const floats &a, const floats &b, const floats &c) { return vfmaq_f32(c, a, b); }
inline floats fnma(const floats &a, const floats &b, const floats &c) { return vfmsq_f32(c, a, b); }
inline floats fms(const floats &a, const floats &b, const floats &c) { return vfmaq_f32(vnegq_f32(c), a, b); }
inline doubles fma(const doubles &a, const doubles &b, const doubles &c) { return vfmaq_f64(c, a, b); }
inline doubles fnma(const doubles &a, const doubles &b, const doubles &c) { return vfmsq_f64(c, a, b); }
inline doubles fms(const doubles &a, const doubles &b, const doubles &c) { return vfmaq_f64(vnegq_f64(c), a, b); }
#endif
#endif

inline float sqrt(float a) { return __builtin_sqrtf(a); }
inline double sqrt(double a) { return __builtin_sqrt(a); }

// ------------------------------------------------------------------------------------------ loads and stores
//
// Pointers need no alignment. A partial load reads the first n lanes (0 <= n < width) and fills the others with
// ones, so that the lanes of a tail hold motors and points like any other and raise no floating-point exceptions.

template <class T> inline T read(const void *from)
{
    T value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

template <class T> inline void write(void *to, T value) { __builtin_memcpy(to, &value, sizeof value); }

#if defined(MOTORWAY_ISA_scalar)

template <class T> inline T load(const T *from) { return read<T>(from); }
template <class T> inline void store(T *to, T value) { write(to, value); }
template <class T> inline T load_partial(const T *, int) { return T(1); } // no lane is ever left over
template <class T> inline void store_partial(T *, T, int) {}

#else

template <class T> inline vector<T> load(const T *from) { return vector<T>::load_unaligned(from); }
template <class T> inline void store(T *to, const vector<T> &value) { value.store_unaligned(to); }

#if defined(MOTORWAY_ISA_avx512)

inline __mmask16 first_lanes(int n) { return static_cast<__mmask16>((1u << n) - 1u); }
inline floats load_partial(const float *from, int n)
{
    return _mm512_mask_loadu_ps(_mm512_set1_ps(1), first_lanes(n), from);
}
inline doubles load_partial(const double *from, int n)
{
    return _mm512_mask_loadu_pd(_mm512_set1_pd(1), static_cast<__mmask8>(first_lanes(n)), from);
}
inline void store_partial(float *to, const floats &value, int n) { _mm512_mask_storeu_ps(to, first_lanes(n), value); }
inline void store_partial(double *to, const doubles &value, int n)
{
    _mm512_mask_storeu_pd(to, static_cast<__mmask8>(first_lanes(n)), value);
}

#elif defined(MOTORWAY_ISA_avx2)

inline __m256i first_floats(int n)
{
    return _mm256_cmpgt_epi32(_mm256_set1_epi32(n), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
}
inline __m256i first_doubles(int n) { return _mm256_cmpgt_epi64(_mm256_set1_epi64x(n), _mm256_setr_epi64x(0, 1, 2, 3)); }
inline floats load_partial(const float *from, int n)
{
    const __m256i mask = first_floats(n);
    return _mm256_blendv_ps(_mm256_set1_ps(1), _mm256_maskload_ps(from, mask), _mm256_castsi256_ps(mask));
}
inline doubles load_partial(const double *from, int n)
{
    const __m256i mask = first_doubles(n);
    return _mm256_blendv_pd(_mm256_set1_pd(1), _mm256_maskload_pd(from, mask), _mm256_castsi256_pd(mask));
}
inline void store_partial(float *to, const floats &value, int n) { _mm256_maskstore_ps(to, first_floats(n), value); }
inline void store_partial(double *to, const doubles &value, int n) { _mm256_maskstore_pd(to, first_doubles(n), value); }

#else

template <class T> inline vector<T> load_partial(const T *from, int n)
{
    T lanes[width<T>];
    for (int lane = 0; lane < width<T>; ++lane)
        lanes[lane] = lane < n ? read<T>(from + lane) : T(1);
    return load(lanes);
}
template <class T> inline void store_partial(T *to, const vector<T> &value, int n)
{
    T lanes[width<T>];
    store(lanes, value);
    for (int lane = 0; lane < n; ++lane)
        write(to + lane, lanes[lane]);
}

#endif

// --------------------------------------------------------------------------------------------------- shuffles

// Lane j is lane `Lane[j]` of the concatenation of a and b; -1 where it does not matter.
template <int... Lane, class T, class A>
inline xsimd::batch<T, A> shuffle(const xsimd::batch<T, A> &a, const xsimd::batch<T, A> &b)
{
    using native = typename xsimd::batch<T, A>::register_type;
    return xsimd::batch<T, A>(__builtin_shufflevector(static_cast<native>(a), static_cast<native>(b), Lane...));
}

#endif

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
