// Vectors of one instruction set. The only file that names xsimd or an intrinsic.
//
// A unit defines MOTORWAY_ISA_<name> and includes this once. xsimd is put into a namespace of the unit's own:
// its inline functions are compiled with the unit's flags, and the linker would otherwise keep one copy for all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
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

// -a where the compiler does not see what a is: where it fuses GCC makes -a b - c of -(a b + c), which is 0 and not -0
// if they cancel. The empty statement keeps it from that.
template <class T> inline T negated(T a)
{
#if defined(__x86_64__) || defined(__i386__)
    asm("" : "+x"(a));
#elif defined(__aarch64__)
    asm("" : "+w"(a));
#endif
    return -a;
}

// a b + c, c - a b and a b - c: one rounding where the instruction set fuses, two where it does not. Square roots
// and the four operations are xsimd's.
#if defined(MOTORWAY_ISA_scalar) || defined(MOTORWAY_ISA_sse2)
constexpr bool fuses = false;
template <class V> inline V fma(const V &a, const V &b, const V &c) { return a * b + c; }
template <class V> inline V fnma(const V &a, const V &b, const V &c) { return c - a * b; }
template <class V> inline V fms(const V &a, const V &b, const V &c) { return a * b - c; }
#else
constexpr bool fuses = true;
inline float fma(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
inline double fma(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline float fnma(float a, float b, float c) { return __builtin_fmaf(negated(a), b, c); }
inline double fnma(double a, double b, double c) { return __builtin_fma(negated(a), b, c); }
inline float fms(float a, float b, float c) { return __builtin_fmaf(a, b, negated(c)); }
inline double fms(double a, double b, double c) { return __builtin_fma(a, b, negated(c)); }

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
inline doubles fma(const doubles &a, const doubles &b, const doubles &c) { return vfmaq_f64(c, a, b); }
inline floats fnma(const floats &a, const floats &b, const floats &c) { return fma(negated(a.data), b, c); }
inline doubles fnma(const doubles &a, const doubles &b, const doubles &c) { return fma(negated(a.data), b, c); }
inline floats fms(const floats &a, const floats &b, const floats &c) { return fma(a, b, negated(c.data)); }
inline doubles fms(const doubles &a, const doubles &b, const doubles &c) { return fma(a, b, negated(c.data)); }
#endif
#endif

// The sign bit alone: 0 becomes -0, which is not what every version of xsimd makes of it.
inline float negate(float a) { return negated(a); }
inline double negate(double a) { return negated(a); }
#if !defined(MOTORWAY_ISA_scalar)
template <class T, class A> inline xsimd::batch<T, A> negate(const xsimd::batch<T, A> &a)
{
    using native = typename xsimd::batch<T, A>::register_type;
    return xsimd::batch<T, A>(-static_cast<native>(a));
}
#endif

inline float sqrt(float a) { return __builtin_sqrtf(a); }
inline double sqrt(double a) { return __builtin_sqrt(a); }

// What a vector is made of, which for a scalar is itself.
template <class V> struct scalar_type { using type = V; };
#if !defined(MOTORWAY_ISA_scalar)
template <class T, class A> struct scalar_type<xsimd::batch<T, A>> { using type = T; };
#endif
template <class V> using scalar_of = typename scalar_type<V>::type;
template <class V> constexpr bool is_single = std::is_same_v<scalar_of<V>, float>;

// The polynomial of these coefficients, from the constant upwards.
template <int K = 0, class V, int N> inline V horner(const V &x, const scalar_of<V> (&coefficient)[N])
{
    if constexpr (K == N - 1)
        return V(coefficient[K]);
    else
        return fma(horner<K + 1>(x, coefficient), x, V(coefficient[K]));
}

// The larger of two; a value that is NaN stays one.
template <class T> inline T at_least_scalar(T value, T bound) { return value < bound ? bound : value; }
inline float at_least(float value, float bound) { return at_least_scalar(value, bound); }
inline double at_least(double value, double bound) { return at_least_scalar(value, bound); }

inline float magnitude(float a) { return __builtin_fabsf(a); }
inline double magnitude(double a) { return __builtin_fabs(a); }
inline float with_sign(float a, float sign) { return __builtin_copysignf(a, sign); }
inline double with_sign(double a, double sign) { return __builtin_copysign(a, sign); }
inline float if_less(float a, float b, float then, float otherwise) { return a < b ? then : otherwise; }
inline double if_less(double a, double b, double then, double otherwise) { return a < b ? then : otherwise; }

// The sign flipped where the last bit of another number is set.
template <class Bits, class T> inline T with_flipped_sign_scalar(T value, T other)
{
    Bits bits, last;
    __builtin_memcpy(&bits, &value, sizeof bits);
    __builtin_memcpy(&last, &other, sizeof last);
    bits ^= last << (8 * sizeof last - 1);
    __builtin_memcpy(&value, &bits, sizeof bits);
    return value;
}
inline float with_flipped_sign(float value, float other)
{
    return with_flipped_sign_scalar<std::uint32_t>(value, other);
}
inline double with_flipped_sign(double value, double other)
{
    return with_flipped_sign_scalar<std::uint64_t>(value, other);
}

#if !defined(MOTORWAY_ISA_scalar)
template <class T, class A>
inline xsimd::batch<T, A> with_flipped_sign(const xsimd::batch<T, A> &value, const xsimd::batch<T, A> &other)
{
    using native = typename xsimd::batch<T, A>::register_type;
    using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    typedef bits integers __attribute__((vector_size(sizeof(native))));
    const native given = value, last = other;
    return native(integers(given) ^ (integers(last) << (8 * sizeof(T) - 1)));
}
template <class T, class A> inline xsimd::batch<T, A> magnitude(const xsimd::batch<T, A> &a) { return xsimd::abs(a); }
template <class T, class A>
inline xsimd::batch<T, A> with_sign(const xsimd::batch<T, A> &a, const xsimd::batch<T, A> &sign)
{
    return xsimd::copysign(a, sign);
}
template <class T, class A>
inline xsimd::batch<T, A> if_less(const xsimd::batch<T, A> &a, const xsimd::batch<T, A> &b,
                                  const xsimd::batch<T, A> &then, const xsimd::batch<T, A> &otherwise)
{
    return xsimd::select(a < b, then, otherwise);
}
#endif

// Whether every lane is within [low, below), or between low and high, both included. Not if one is NaN.
inline bool all_within(float a, float low, float below) { return low <= a && a < below; }
inline bool all_within(double a, double low, double below) { return low <= a && a < below; }
inline bool all_between(float a, float low, float high) { return low <= a && a <= high; }
inline bool all_between(double a, double low, double high) { return low <= a && a <= high; }
#if !defined(MOTORWAY_ISA_scalar)
template <class T, class A> inline bool all_within(const xsimd::batch<T, A> &a, T low, T below)
{
    using V = xsimd::batch<T, A>;
    return xsimd::all((V(low) <= a) & (a < V(below)));
}
template <class T, class A> inline bool all_between(const xsimd::batch<T, A> &a, T low, T high)
{
    using V = xsimd::batch<T, A>;
    return xsimd::all((V(low) <= a) & (a <= V(high)));
}
#endif

// The nearest integer, of two the even one. Adding and taking off 1.5 · 2^23 (2^52 in double) rounds to integers;
// what is too large for that is one.
template <class V> inline V nearest_by_adding(const V &a)
{
    using T = scalar_of<V>;
    const V large(is_single<V> ? T(0x1.8p23) : T(0x1.8p52));
    return if_less(magnitude(a), V(is_single<V> ? T(0x1p22) : T(0x1p51)), (a + large) - large, a);
}
#if defined(MOTORWAY_ISA_scalar) || defined(MOTORWAY_ISA_sse2)
template <class V> inline V nearest(const V &a) { return nearest_by_adding(a); }
#else
inline float nearest(float a) { return nearest_by_adding(a); }
inline double nearest(double a) { return nearest_by_adding(a); }
#endif
#if defined(MOTORWAY_ISA_avx512) || defined(MOTORWAY_ISA_avx2)
constexpr int to_nearest = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
#endif
#if defined(MOTORWAY_ISA_avx512)
inline floats at_least(const floats &value, const floats &bound) { return _mm512_max_ps(bound, value); }
inline doubles at_least(const doubles &value, const doubles &bound) { return _mm512_max_pd(bound, value); }
inline floats nearest(const floats &a) { return _mm512_roundscale_ps(a, to_nearest); }
inline doubles nearest(const doubles &a) { return _mm512_roundscale_pd(a, to_nearest); }
#elif defined(MOTORWAY_ISA_avx2)
inline floats at_least(const floats &value, const floats &bound) { return _mm256_max_ps(bound, value); }
inline doubles at_least(const doubles &value, const doubles &bound) { return _mm256_max_pd(bound, value); }
inline floats nearest(const floats &a) { return _mm256_round_ps(a, to_nearest); }
inline doubles nearest(const doubles &a) { return _mm256_round_pd(a, to_nearest); }
#elif defined(MOTORWAY_ISA_sse2)
inline vector<float> at_least(const vector<float> &value, const vector<float> &bound)
{
    return _mm_max_ps(bound, value);
}
inline vector<double> at_least(const vector<double> &value, const vector<double> &bound)
{
    return _mm_max_pd(bound, value);
}
#elif defined(MOTORWAY_ISA_neon64)
inline floats at_least(const floats &value, const floats &bound) { return vmaxq_f32(value, bound); }
inline doubles at_least(const doubles &value, const doubles &bound) { return vmaxq_f64(value, bound); }
inline floats nearest(const floats &a) { return vrndnq_f32(a); }
inline doubles nearest(const doubles &a) { return vrndnq_f64(a); }
#endif

// Whether any lanes of two registers come together in one instruction.
#if defined(MOTORWAY_ISA_avx512)
constexpr bool permutes_are_cheap = true;
#else
constexpr bool permutes_are_cheap = false;
#endif

// Lanes that shuffles move among themselves at little cost.
#if defined(MOTORWAY_ISA_avx2)
template <class T> constexpr int group = 16 / static_cast<int>(sizeof(T));
#else
template <class T> constexpr int group = width<T>;
#endif

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
template <class T> inline void keep(T &) {}
template <class T> inline T load_partial(const T *, int) { return T(1); } // no lane is ever left over
template <class T> inline void store_partial(T *, T, int) {}
template <class T> inline T load_groups(const T *from, int) { return read<T>(from); }
template <class T> inline void store_groups(T *to, T value, int) { write(to, value); }

#else

template <class T> inline vector<T> load(const T *from) { return vector<T>::load_unaligned(from); }
template <class T> inline void store(T *to, const vector<T> &value) { value.store_unaligned(to); }

// Keeps a loaded value in its register: GCC would otherwise load it again for each of its uses.
template <class T, class A> inline void keep(xsimd::batch<T, A> &value)
{
    auto native = static_cast<typename xsimd::batch<T, A>::register_type>(value);
#if defined(MOTORWAY_ISA_neon64)
    asm("" : "+w"(native));
#else
    asm("" : "+v"(native));
#endif
    value = native;
}

// The groups of a register from, and to, memory at a distance of `step` scalars.
#if defined(MOTORWAY_ISA_avx2)
inline floats load_groups(const float *from, int step)
{
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(from)), _mm_loadu_ps(from + step), 1);
}
inline doubles load_groups(const double *from, int step)
{
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(from)), _mm_loadu_pd(from + step), 1);
}
inline void store_groups(float *to, const floats &value, int step)
{
    _mm_storeu_ps(to, _mm256_castps256_ps128(value));
    _mm_storeu_ps(to + step, _mm256_extractf128_ps(value, 1));
}
inline void store_groups(double *to, const doubles &value, int step)
{
    _mm_storeu_pd(to, _mm256_castpd256_pd128(value));
    _mm_storeu_pd(to + step, _mm256_extractf128_pd(value, 1));
}
#else // one group a register
template <class T> inline vector<T> load_groups(const T *from, int) { return load(from); }
template <class T> inline void store_groups(T *to, const vector<T> &value, int) { store(to, value); }
#endif

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
// Stores of whole 16, 8 and 4 bytes: AMD runs a masked store as microcode, some fifty cycles each.
inline void store_first(float *to, __m128 lanes, int n)
{
    if (n & 2) {
        _mm_storel_pi(reinterpret_cast<__m64 *>(to), lanes);
        to += 2, lanes = _mm_movehl_ps(lanes, lanes);
    }
    if (n & 1)
        _mm_store_ss(to, lanes);
}
inline void store_partial(float *to, const floats &value, int n)
{
    if (n == 8) // up to a cache line there may be a whole register
        return store(to, value);
    const __m128 low = _mm256_castps256_ps128(value), high = _mm256_extractf128_ps(value, 1);
    if (n & 4)
        _mm_storeu_ps(to, low);
    store_first(to + (n & 4), n & 4 ? high : low, n & 3);
}
inline void store_partial(double *to, const doubles &value, int n)
{
    if (n == 4)
        return store(to, value);
    const __m128d low = _mm256_castpd256_pd128(value), high = _mm256_extractf128_pd(value, 1);
    if (n & 2)
        _mm_storeu_pd(to, low);
    if (n & 1)
        _mm_store_sd(to + (n & 2), n & 2 ? high : low);
}

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

// The first lanes; the others are zero.
template <class T, class... Lanes> inline vector<T> from_lanes(Lanes... lanes)
{
    using native = typename vector<T>::register_type;
    return vector<T>(native{lanes...});
}

// Lane j is lane `Lane[j]` of the concatenation of a and b; -1 where it does not matter.
template <int... Lane, class T, class A>
inline xsimd::batch<T, A> shuffle(const xsimd::batch<T, A> &a, const xsimd::batch<T, A> &b)
{
    using native = typename xsimd::batch<T, A>::register_type;
    return xsimd::batch<T, A>(__builtin_shufflevector(static_cast<native>(a), static_cast<native>(b), Lane...));
}

// ------------------------------------------------------------------------------------------------------- rows
//
// A row is up to four adjacent scalars in memory. A register of rows holds one in each group of four lanes.

template <class T> constexpr int rows = width<T> / 4; // in a register; 0 where a row does not fit

// The first `Size` scalars of each row; the other lanes are zero.
template <int Size, class T> inline vector<T> load_rows(const T *const *row)
{
    static_assert(Size <= 4 && rows<T> > 0);
#if defined(MOTORWAY_ISA_avx512)
    constexpr unsigned first = (1u << Size) - 1;
    if constexpr (sizeof(T) == 4) {
        __m512 r = _mm512_maskz_broadcast_f32x4(first, _mm_maskz_loadu_ps(first, row[0]));
        r = _mm512_mask_broadcast_f32x4(r, first << 4, _mm_maskz_loadu_ps(first, row[1]));
        r = _mm512_mask_broadcast_f32x4(r, first << 8, _mm_maskz_loadu_ps(first, row[2]));
        return _mm512_mask_broadcast_f32x4(r, first << 12, _mm_maskz_loadu_ps(first, row[3]));
    } else {
        __m512d r = _mm512_maskz_broadcast_f64x4(first, _mm256_maskz_loadu_pd(first, row[0]));
        return _mm512_mask_broadcast_f64x4(r, first << 4, _mm256_maskz_loadu_pd(first, row[1]));
    }
#elif defined(MOTORWAY_ISA_avx2)
    if constexpr (sizeof(T) == 4) {
        const __m128i mask = _mm_setr_epi32(-1, Size > 1 ? -1 : 0, Size > 2 ? -1 : 0, Size > 3 ? -1 : 0);
        const auto load_row = [=](const float *from) {
            return Size == 4 ? _mm_loadu_ps(from) : _mm_maskload_ps(from, mask);
        };
        return _mm256_insertf128_ps(_mm256_castps128_ps256(load_row(row[0])), load_row(row[1]), 1);
    } else if constexpr (Size == 4)
        return load(row[0]);
    else
        return _mm256_maskload_pd(row[0], first_doubles(Size));
#else
    if constexpr (Size == 4)
        return load(row[0]);
    else if constexpr (Size == 3)
        return from_lanes<T>(read<T>(row[0]), read<T>(row[0] + 1), read<T>(row[0] + 2), T(0));
    else
        return from_lanes<T>(read<T>(row[0]), Size > 1 ? read<T>(row[0] + 1) : T(0), T(0), T(0));
#endif
}

#if defined(MOTORWAY_ISA_avx512)
// GCC would merge taking a row out of a register and its masked store into one instruction, which, unlike the store
// alone, faults at addresses that the mask leaves out. The empty statement keeps them apart.
inline void store_row_masked(float *to, __mmask8 mask, __m128 row)
{
    asm("" : "+v"(row));
    _mm_mask_storeu_ps(to, mask, row);
}
inline void store_row_masked(double *to, __mmask8 mask, __m256d row)
{
    asm("" : "+v"(row));
    _mm256_mask_storeu_pd(to, mask, row);
}
#endif

template <int Size, class T> inline void store_rows(T *const *row, const vector<T> &value)
{
    static_assert(Size <= 4 && rows<T> > 0);
#if defined(MOTORWAY_ISA_avx512)
    constexpr __mmask8 first = (1u << Size) - 1;
    if constexpr (sizeof(T) == 4) {
        store_row_masked(row[0], first, _mm512_castps512_ps128(value));
        store_row_masked(row[1], first, _mm512_extractf32x4_ps(value, 1));
        store_row_masked(row[2], first, _mm512_extractf32x4_ps(value, 2));
        store_row_masked(row[3], first, _mm512_extractf32x4_ps(value, 3));
    } else {
        store_row_masked(row[0], first, _mm512_castpd512_pd256(value));
        store_row_masked(row[1], first, _mm512_extractf64x4_pd(value, 1));
    }
#elif defined(MOTORWAY_ISA_avx2)
    if constexpr (sizeof(T) == 4) {
        const auto store_row = [](float *to, __m128 lanes) {
            Size == 4 ? _mm_storeu_ps(to, lanes) : store_first(to, lanes, Size);
        };
        store_row(row[0], _mm256_castps256_ps128(value));
        store_row(row[1], _mm256_extractf128_ps(value, 1));
    } else if constexpr (Size == 4)
        store(row[0], value);
    else
        store_partial(row[0], value, Size);
#else
    store_partial(row[0], value, Size);
#endif
}

#endif

// ------------------------------------------------------------------------------------------------------- motors
//
// A motor in memory, eight adjacent scalars, as one or more registers: where elements are blended one at a time.

#if defined(MOTORWAY_ISA_scalar)
template <class T> using motor_part = T;
template <class T> inline motor_part<T> load_motor_part(const T *from) { return *from; }
template <class T> inline void store_motor_part(T *to, const motor_part<T> &value) { *to = value; }
#elif defined(MOTORWAY_ISA_avx512)
template <class T>
using motor_part = std::conditional_t<sizeof(T) == 4, xsimd::batch<float, xsimd::fma3<xsimd::avx2>>, vector<T>>;
inline motor_part<float> fma(const motor_part<float> &a, const motor_part<float> &b, const motor_part<float> &c)
{
    return _mm256_fmadd_ps(a, b, c);
}
#else
template <class T> using motor_part = vector<T>;
#endif
#if !defined(MOTORWAY_ISA_scalar)
template <class T> inline motor_part<T> load_motor_part(const T *from) { return motor_part<T>::load_unaligned(from); }
template <class T> inline void store_motor_part(T *to, const motor_part<T> &value) { value.store_unaligned(to); }
#endif
template <class T> constexpr int motor_parts = 8 * static_cast<int>(sizeof(T)) / static_cast<int>(sizeof(motor_part<T>));

// ------------------------------------------------------------------------------------------- past the caches
//
// Stores that go to memory without a place in a cache; addresses are multiples of a group. `fence` puts them before
// all stores that follow.

constexpr std::size_t cache_line = 64;

#if defined(MOTORWAY_ISA_avx512)
constexpr bool has_streaming_stores = true;
inline void store_streaming(float *to, const floats &value) { _mm512_stream_ps(to, value); }
inline void store_streaming(double *to, const doubles &value) { _mm512_stream_pd(to, value); }
#elif defined(MOTORWAY_ISA_avx2)
constexpr bool has_streaming_stores = true;
inline void store_streaming(float *to, const floats &value) { _mm256_stream_ps(to, value); }
inline void store_streaming(double *to, const doubles &value) { _mm256_stream_pd(to, value); }
#elif defined(MOTORWAY_ISA_sse2)
constexpr bool has_streaming_stores = true;
inline void store_streaming(float *to, const vector<float> &value) { _mm_stream_ps(to, value); }
inline void store_streaming(double *to, const vector<double> &value) { _mm_stream_pd(to, value); }
#else
constexpr bool has_streaming_stores = false;
template <class T> inline void store_streaming(T *to, const vector<T> &value) { store(to, value); }
#endif

#if defined(MOTORWAY_ISA_avx2)
inline void store_groups_streaming(float *to, const floats &value, int step)
{
    _mm_stream_ps(to, _mm256_castps256_ps128(value));
    _mm_stream_ps(to + step, _mm256_extractf128_ps(value, 1));
}
inline void store_groups_streaming(double *to, const doubles &value, int step)
{
    _mm_stream_pd(to, _mm256_castpd256_pd128(value));
    _mm_stream_pd(to + step, _mm256_extractf128_pd(value, 1));
}
#else
template <class T> inline void store_groups_streaming(T *to, const vector<T> &value, int)
{
    store_streaming(to, value);
}
#endif

#if defined(MOTORWAY_ISA_sse2) || defined(MOTORWAY_ISA_avx2) || defined(MOTORWAY_ISA_avx512)
inline void fence() { _mm_sfence(); }
#else
inline void fence() {}
#endif

// ------------------------------------------------------------------------------------------------ conversions
//
// A register of floats is two of doubles, `half` 0 and 1; a scalar is one.

#if defined(MOTORWAY_ISA_scalar)
inline double to_doubles(float value, int) { return value; }
#elif defined(MOTORWAY_ISA_avx512)
inline doubles to_doubles(const floats &value, int half)
{
    return _mm512_cvtps_pd(half ? _mm512_extractf32x8_ps(value, 1) : _mm512_castps512_ps256(value));
}
inline floats to_floats(const doubles &low, const doubles &high)
{
    return _mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(low)), _mm512_cvtpd_ps(high), 1);
}
#elif defined(MOTORWAY_ISA_avx2)
inline doubles to_doubles(const floats &value, int half)
{
    return _mm256_cvtps_pd(half ? _mm256_extractf128_ps(value, 1) : _mm256_castps256_ps128(value));
}
inline floats to_floats(const doubles &low, const doubles &high)
{
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(low)), _mm256_cvtpd_ps(high), 1);
}
#elif defined(MOTORWAY_ISA_sse2)
inline vector<double> to_doubles(const vector<float> &value, int half)
{
    return _mm_cvtps_pd(half ? _mm_movehl_ps(value, value) : static_cast<__m128>(value));
}
inline vector<float> to_floats(const vector<double> &low, const vector<double> &high)
{
    return _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high));
}
#elif defined(MOTORWAY_ISA_neon64)
inline doubles to_doubles(const floats &value, int half)
{
    return half ? vcvt_high_f64_f32(value) : vcvt_f64_f32(vget_low_f32(value));
}
inline floats to_floats(const doubles &low, const doubles &high) { return vcvt_high_f32_f64(vcvt_f32_f64(low), high); }
#endif

// What a kernel computes in, T, from what its elements are made of, and back. The same, or double and float.
template <class T, class V> inline vector<T> widen(const V &value, int half)
{
    if constexpr (std::is_same_v<V, vector<T>>)
        return value;
    else
        return to_doubles(value, half);
}
template <class E, class V> inline vector<E> narrow(const V &value) { return static_cast<vector<E>>(value); }
#if !defined(MOTORWAY_ISA_scalar)
template <class E, class V> inline vector<E> narrow(const V &low, const V &high) { return to_floats(low, high); }
#endif

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
