#include "motion.h"

#include "kernel_call.h"

#include <algorithm>
#include <cmath>

namespace motorway {

namespace {

// Knots must not decrease, and d + 2 equal ones would leave a control without any influence.
template <class T> bool is_bad_knot(const bspline<T> &motion, std::size_t i)
{
    const T *knots = motion.knots;
    const std::size_t most = motion.degree + 1u;
    return !std::isfinite(knots[i]) || (i > 0 && knots[i] < knots[i - 1]) || (i >= most && knots[i] == knots[i - most]);
}

// The index j of the knots t_j < t_j+1 between which a parameter of the domain lies.
template <class T> std::size_t find_span(const bspline<T> &motion, T t)
{
    const T *first = motion.knots + (motion.degree - 1), *last = motion.knots + (motion.control_count - 1);
    const T *after = t < *last ? std::upper_bound(first, last, t)  // the first knot above t
                               : std::lower_bound(first, last, t); // the end belongs to the last span
    return static_cast<std::size_t>(after - motion.knots) - 1;
}

// As many samples as are blended in one call of the kernel: their weights stay in the L1 cache.
constexpr std::size_t block = 64;

// The weights of the d + 1 controls of a span, for up to `block` parameters in it: the blossom recursion of Hunt et
// al., run backwards from the result, where it acts on weights instead of motors. Level r of the tableau combines
// two neighbours over the knots l and l + r. Every weight is accurate to its own last bits, and exact at both ends.
template <class T>
void blossom_weights(const bspline<T> &motion, std::size_t span, const T *parameters, std::size_t count,
                     T (&weights)[MW_MAX_DEGREE + 1][block])
{
    const T *knots = motion.knots;
    std::fill_n(weights[0], count, T(1));
    for (std::size_t r = 1; r <= motion.degree; ++r) {
        std::fill_n(weights[r], count, T(0));
        for (std::size_t k = r; k-- > 0;) {
            const T left = knots[span + 1 + k - r], right = knots[span + 1 + k];
            for (std::size_t i = 0; i < count; ++i) {
                const T weight = weights[k][i], t = parameters[i];
                weights[k][i] = weight * ((right - t) / (right - left));
                weights[k + 1][i] += weight * ((t - left) / (right - left));
            }
        }
    }
}

} // namespace

template <class T> mw_status check_bspline(const bspline<T> &motion, std::size_t *where)
{
    std::size_t ignored;
    std::size_t &index = where ? *where : ignored;
    index = 0;
    if (!motion.controls || !motion.knots)
        return MW_ERROR_NULL;
    if (motion.degree < 1 || motion.degree > MW_MAX_DEGREE)
        return MW_ERROR_DEGREE;
    if (motion.control_count < motion.degree + 1u)
        return MW_ERROR_CONTROL_COUNT;
    if (motion.knot_count != motion.control_count + motion.degree - 1)
        return MW_ERROR_KNOT_COUNT;
    for (std::size_t i = 0; i < motion.knot_count; ++i)
        if (is_bad_knot(motion, i)) {
            index = i;
            return MW_ERROR_KNOTS;
        }
    if (!(motion.domain_begin() < motion.domain_end())) {
        index = motion.control_count - 1;
        return MW_ERROR_KNOTS;
    }
    for (std::size_t i = 0; i < motion.control_count; ++i)
        if (is_degenerate(motion.controls + 8 * i)) {
            index = i;
            return MW_ERROR_DEGENERATE_MOTOR;
        }
    return MW_OK;
}

template <class T>
mw_status sample_bspline(const kernel_table &table, const view<T, 8> &out, const bspline<T> &motion,
                         const T *parameters, std::size_t count)
{
    const T begin = motion.domain_begin(), end = motion.domain_end();
    for (std::size_t i = 0; i < count; ++i)
        if (!(parameters[i] >= begin && parameters[i] <= end))
            return MW_ERROR_PARAMETER;

    T weights[MW_MAX_DEGREE + 1][block];
    const T *terms[MW_MAX_DEGREE + 1];
    for (std::size_t k = 0; k <= motion.degree; ++k)
        terms[k] = weights[k];
    const stream<const T> weight_stream{terms, sizeof(T), layout::soa};

    for (std::size_t i = 0, run; i < count; i += run) {
        const std::size_t span = find_span(motion, parameters[i]);
        for (run = 1; run < block && i + run < count && find_span(motion, parameters[i + run]) == span;)
            ++run;
        blossom_weights(motion, span, parameters + i, run, weights);
        const view<T, 8> rest = out.from(i);
        const T *controls = motion.controls + 8 * (span + 1 - motion.degree);
        run_blend(table, kernel_id::blend_motor_one, rest, &weight_stream, controls, motion.degree + 1u, run);
    }
    return MW_OK;
}

#define MOTORWAY_INSTANTIATE(T)                                                                                       \
    template mw_status check_bspline(const bspline<T> &, std::size_t *);                                              \
    template mw_status sample_bspline(const kernel_table &, const view<T, 8> &, const bspline<T> &, const T *,        \
                                      std::size_t);
MOTORWAY_INSTANTIATE(float)
MOTORWAY_INSTANTIATE(double)
#undef MOTORWAY_INSTANTIATE

} // namespace motorway
