// Weighted sums of motors. Validate, look up, call, return a status.
#include "dispatch.h"
#include "view.h"

namespace motorway {
namespace {

// One array per term.
template <class T> struct blend_weights {
    const T *const *terms;
    std::size_t stride;

    view<const T, 1> of_term(std::size_t k) const { return {{terms[k]}, stride}; }
    stream<const T> as_stream() const
    {
        return {terms, stride, stride == sizeof(T) ? layout::soa : layout::interleaved};
    }
};

blend_weights<float> weights_of(const mw_weights_f32 *w) { return {w ? w->terms : nullptr, w ? w->stride : 0}; }
blend_weights<double> weights_of(const mw_weights_f64 *w) { return {w ? w->terms : nullptr, w ? w->stride : 0}; }

template <class T>
mw_status check_weights(const view<T, 8> &out, const blend_weights<T> &weights, std::size_t terms, std::size_t count)
{
    if (terms > 0 && !weights.terms)
        return MW_ERROR_NULL;
    mw_status status = MW_OK;
    for (std::size_t k = 0; k < terms && status == MW_OK; ++k)
        status = first_error(check_view(weights.of_term(k), count),
                             [&] { return check_overlap(out, weights.of_term(k), count); });
    return status;
}

template <class T>
void run_blend(kernel_id id, const view<T, 8> &out, const stream<const T> *in, const T *controls, std::size_t terms,
               std::size_t count)
{
    const stream<T> to = out.as_stream();
    call<T> arguments{&to, in, count, controls};
    arguments.terms = terms;
    kernel_of<T>(id)(arguments);
}

template <class T>
mw_status blend_motor_one(const view<T, 8> &out, const T *controls, const blend_weights<T> &weights, std::size_t terms,
                    std::size_t count)
{
    if (!kernels() || count == 0)
        return kernels() ? MW_OK : MW_ERROR_ISA;
    if (terms > PTRDIFF_MAX / (8 * sizeof(T)))
        return MW_ERROR_SIZE;
    const mw_status status = first_error(
        check_view(out, count), [&] { return terms ? check_array(controls, 8 * terms) : MW_OK; },
        [&] { return check_weights(out, weights, terms, count); },
        [&] { return check_overlap(out, controls, 8 * terms, count); });
    if (status != MW_OK)
        return status;
    const stream<const T> in = weights.as_stream();
    run_blend(kernel_id::blend_motor_one, out, &in, controls, terms, count);
    return MW_OK;
}

template <class T, class Motors>
mw_status blend_motor_each(const view<T, 8> &out, const Motors *controls, const blend_weights<T> &weights,
                     std::size_t terms, std::size_t count)
{
    if (!kernels() || count == 0)
        return kernels() ? MW_OK : MW_ERROR_ISA;
    if (terms > MW_MAX_TERMS)
        return MW_ERROR_TERM_COUNT;
    if (terms > 0 && !controls)
        return MW_ERROR_NULL;
    mw_status status = first_error(check_view(out, count), [&] { return check_weights(out, weights, terms, count); });
    view<const T, 8> views[MW_MAX_TERMS];
    stream<const T> in[1 + MW_MAX_TERMS] = {weights.as_stream()};
    for (std::size_t k = 0; k < terms && status == MW_OK; ++k) {
        views[k] = view_of(controls[k]);
        in[1 + k] = views[k].as_stream();
        status = first_error(check_view(views[k], count), [&] { return check_overlap(out, views[k], count); });
    }
    if (status == MW_OK)
        run_blend<T>(kernel_id::blend_motor_each, out, in, nullptr, terms, count);
    return status;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../generated/calls/blend.inc"
