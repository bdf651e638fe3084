// A stream loop in the manner of DirectXMath's XMVector3TransformCoordStream: the matrix in rows for row vectors,
// four points at a time from any byte stride, one register a point, in each of which a component is spread over all
// lanes and multiplied with a row. Without its division by w, which is 1 after a rigid motion. f32 alone, as there.
#include "baseline.h"

#ifdef __SSE2__
#include <immintrin.h>

#endif

namespace motorway::bench {

template <class T> work bind_stream(const problem<T> &) { return {}; }

#ifdef __SSE2__
namespace {

struct row_matrix {
    __m128 rows[4];
};

row_matrix rows_of(const rigid &r, bool translates)
{
    row_matrix m;
    for (int k = 0; k < 3; ++k)
        m.rows[k] = _mm_setr_ps(static_cast<float>(r.rotation[0][k]), static_cast<float>(r.rotation[1][k]),
                                static_cast<float>(r.rotation[2][k]), 0);
    m.rows[3] = translates ? _mm_setr_ps(static_cast<float>(r.translation[0]), static_cast<float>(r.translation[1]),
                                         static_cast<float>(r.translation[2]), 1)
                           : _mm_setzero_ps();
    return m;
}

inline __m128 multiply_add(__m128 a, __m128 b, __m128 c)
{
#ifdef __FMA__
    return _mm_fmadd_ps(a, b, c);
#else
    return _mm_add_ps(_mm_mul_ps(a, b), c);
#endif
}

template <int K> inline __m128 spread(__m128 v) { return _mm_shuffle_ps(v, v, _MM_SHUFFLE(K, K, K, K)); }

inline __m128 transform(__m128 point, const row_matrix &m)
{
    const __m128 z = multiply_add(spread<2>(point), m.rows[2], m.rows[3]);
    return multiply_add(spread<0>(point), m.rows[0], multiply_add(spread<1>(point), m.rows[1], z));
}

inline __m128 load_point(const char *from)
{
    const __m128 xy = _mm_castpd_ps(_mm_load_sd(reinterpret_cast<const double *>(from)));
    return _mm_movelh_ps(xy, _mm_load_ss(reinterpret_cast<const float *>(from + 8)));
}

inline void store_point(char *to, __m128 point)
{
    _mm_store_sd(reinterpret_cast<double *>(to), _mm_castps_pd(point));
    _mm_store_ss(reinterpret_cast<float *>(to + 8), spread<2>(point));
}

// Three registers of four packed points into a register a point, and back.
inline void transform_four_packed(float *to, const float *from, const row_matrix &m)
{
    const __m128 a = _mm_loadu_ps(from), b = _mm_loadu_ps(from + 4), c = _mm_loadu_ps(from + 8);
    const auto bytes = [](__m128 v) { return _mm_castps_si128(v); };
    const __m128 p0 = transform(a, m);
    const __m128 p1 = transform(_mm_shuffle_ps(_mm_shuffle_ps(a, b, _MM_SHUFFLE(0, 0, 3, 3)), b,
                                               _MM_SHUFFLE(1, 1, 2, 0)), m);
    const __m128 p2 = transform(_mm_shuffle_ps(b, c, _MM_SHUFFLE(0, 0, 3, 2)), m);
    const __m128 p3 = transform(_mm_castsi128_ps(_mm_srli_si128(bytes(c), 4)), m);
    const __m128 x1_z0 = _mm_shuffle_ps(p1, p0, _MM_SHUFFLE(2, 2, 0, 0));
    const __m128 z2_x3 = _mm_shuffle_ps(p2, p3, _MM_SHUFFLE(0, 0, 2, 2));
    _mm_storeu_ps(to, _mm_shuffle_ps(p0, x1_z0, _MM_SHUFFLE(0, 2, 1, 0)));
    _mm_storeu_ps(to + 4, _mm_shuffle_ps(p1, p2, _MM_SHUFFLE(1, 0, 2, 1)));
    _mm_storeu_ps(to + 8, _mm_shuffle_ps(z2_x3, p3, _MM_SHUFFLE(2, 1, 2, 0)));
}

void transform_stream(char *out, std::size_t out_stride, const char *in, std::size_t in_stride, std::size_t count,
                      const row_matrix &matrix)
{
    const row_matrix m = matrix;
    std::size_t i = 0;
    if (in_stride == 12 && out_stride == 12)
        for (; i + 4 <= count; i += 4, in += 48, out += 48)
            transform_four_packed(reinterpret_cast<float *>(out), reinterpret_cast<const float *>(in), m);
    for (; i + 4 <= count; i += 4, in += 4 * in_stride, out += 4 * out_stride)
        for (int k = 0; k < 4; ++k)
            store_point(out + k * out_stride, transform(load_point(in + k * in_stride), m));
    for (; i < count; ++i, in += in_stride, out += out_stride)
        store_point(out, transform(load_point(in), m));
}

} // namespace

template <> work bind_stream(const problem<float> &p)
{
    const bool point = p.kernel == "apply_point_one";
    if (p.kind == layout::soa || !(point || p.kernel == "apply_direction_one"))
        return {};
    const auto matrix = std::make_shared<row_matrix>(rows_of(rigid_of(fixed_motor(p)), point));
    return make_work([=, in = &p.in[0], out = &p.out[0], count = p.count] {
        transform_stream(reinterpret_cast<char *>(out->component()[0]), out->stride(),
                         reinterpret_cast<const char *>(in->component()[0]), in->stride(), count, *matrix);
    });
}
#else
template work bind_stream(const problem<float> &);
#endif

template work bind_stream(const problem<double> &);

} // namespace motorway::bench
