// mw_sample_motion_...: poses and twists of compiled motions.
#include "sample.h"

namespace motorway {
namespace {

template <class T> using compiled_type = typename c_types<T>::compiled;

// No output shares a byte with the compiled motion, or with a parameter: the kernels look ahead in these.
template <class T, int N>
mw_status check_sampled(const compiled<T> &motion, const numbers<T> &parameters, const view<T, N> &out,
                        std::size_t count)
{
    if (meets_a_component(out, count, motion.range()))
        return MW_ERROR_OVERLAP;
    return parameters.stride == 0 ? MW_OK : check_apart(out, parameters.as_view(), count);
}

template <class T, class... Views>
mw_status check_sample(const outputs<Views...> &out, const compiled_type<T> *motion, const numbers<T> &parameters,
                       std::size_t count, const motion_samples<T> &samples)
{
    mw_status status = check_streams(out, count, parameters);
    std::apply(
        [&](const auto &...each) {
            ((status = status != MW_OK ? status : check_sampled(compiled_of<T>(motion), parameters, each, count)),
             ...);
        },
        out);
    if (status != MW_OK)
        return status;
    return samples.are_sound() ? MW_OK : MW_ERROR_PARAMETER;
}

template <class T, int... N>
mw_status sample(motions_sampled which, const outputs<view<T, N>...> &out, const compiled_type<T> *motion,
                 std::size_t index, const numbers<T> &parameters, std::size_t count, unsigned flags)
{
    mw_status status =
        check_motion_call<T>(motion, which, index, count, flags, sizeof...(N) == 2 ? MW_BODY_FRAME : MW_DEFAULT);
    if (status != MW_OK || count == 0)
        return status;
    const motion_samples<T> samples(compiled_of<T>(motion), which, index, parameters, count, flags);
    status = check_sample<T>(out, motion, parameters, count, samples);
    if (status != MW_OK)
        return status;
    if constexpr (sizeof...(N) == 1)
        samples.sample(std::get<0>(out));
    else
        samples.sample_twist(std::get<0>(out), std::get<1>(out));
    return MW_OK;
}

template <class T>
mw_status sample_motion(motions_sampled which, const view<T, 8> &out, const compiled_type<T> *motion, std::size_t index,
                        const numbers<T> &parameters, std::size_t count, unsigned flags)
{
    return sample<T>(which, into(out), motion, index, parameters, count, flags);
}

template <class T>
mw_status sample_motion_twist(motions_sampled which, const view<T, 8> &out, const view<T, 6> &twists,
                              const compiled_type<T> *motion, std::size_t index, const numbers<T> &parameters,
                              std::size_t count, unsigned flags)
{
    return sample<T>(which, into(out, twists), motion, index, parameters, count, flags);
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../../generated/calls/motion_sample.inc"
