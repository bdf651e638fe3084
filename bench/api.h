// The C API by precision and operand, so that a benchmark is written once for all of them.
#pragma once

#include "motorway_views.h"
#include "problem.h"

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace motorway::bench {

inline void require(mw_status result)
{
    if (result != MW_OK)
        throw std::runtime_error(mw_status_text(result));
}

// api<T>, from the table of public functions.
#include "../generated/api.inc"

// mw_apply_<operand>_... on elements of T under motors of M.
template <operand, class T, class M> struct apply_functions;

using f32 = float;
using f64 = double;
#define MOTORWAY_APPLY_FUNCTIONS(name, views, P)                                                                     \
    template <> struct apply_functions<operand::name, P, P> {                                                        \
        using view = mw_##views##_##P;                                                                               \
        using const_view = mw_const_##views##_##P;                                                                   \
        static constexpr auto one = api<P>::apply_##name##_one;                                                       \
        static constexpr auto each = api<P>::apply_##name##_each;                                                     \
        static constexpr auto grid = api<P>::apply_##name##_grid;                                                     \
        static constexpr auto indexed = api<P>::apply_##name##_indexed;                                               \
        static constexpr auto motion = api<P>::apply_##name##_motion;                                                 \
    };
MW_OPERANDS(MOTORWAY_APPLY_FUNCTIONS, f32)
MW_OPERANDS(MOTORWAY_APPLY_FUNCTIONS, f64)
#undef MOTORWAY_APPLY_FUNCTIONS

// The mixed functions, with a shift.
template <> struct apply_functions<operand::point, float, double> {
    using view = mw_xyz_f32;
    using const_view = mw_const_xyz_f32;

    static mw_status one(const view &out, const mw_motor_f64 *motor, const const_view &in, std::size_t count,
                         unsigned flags)
    {
        return api<mixed>::apply_point_one(out, motor, &moved, in, count, flags);
    }
    static mw_status each(const view &out, const mw_const_motors_f64 &motors, const const_view &in,
                          std::size_t count, unsigned flags)
    {
        return api<mixed>::apply_point_each(out, motors, &moved, in, count, flags);
    }
    static mw_status grid(const view &out, std::size_t row_stride, const mw_const_motors_f64 &motors,
                          std::size_t motor_count, const const_view &in, std::size_t count, unsigned flags)
    {
        return api<mixed>::apply_point_grid(out, row_stride, motors, motor_count, &moved, in, count, flags);
    }
    static mw_status indexed(const view &out, const mw_motor_f64 *palette, std::size_t palette_count,
                             const mw_indices &indices, const const_view &in, std::size_t count, unsigned flags)
    {
        return api<mixed>::apply_point_indexed(out, palette, palette_count, indices, &moved, in, count, flags);
    }

private:
    static constexpr mw_shift moved = {{shift().before[0], shift().before[1], shift().before[2]},
                                       {shift().after[0], shift().after[1], shift().after[2]}};
};

// ------------------------------------------------------------------------------------------------- views of arrays

// Components from number `first` on.
template <class View, class T, std::size_t... k>
View view_of_components(const array<T> &a, std::size_t first, std::size_t stride, std::index_sequence<k...>)
{
    return {a.component()[first + k]..., stride};
}

// A view of the API has a pointer a component and then the stride; or it has two parts, a position and a normal.
template <class View> constexpr std::size_t components_in = sizeof(View) / sizeof(void *) - 1;
template <class View, class T> auto view_of(const array<T> &a, std::size_t stride) -> decltype(View::stride, View())
{
    return view_of_components<View>(a, 0, stride, std::make_index_sequence<components_in<View>>());
}
template <class View, class T> auto view_of(const array<T> &a, std::size_t stride) -> decltype(View::normal, View())
{
    using part = decltype(View::normal);
    constexpr auto components = std::make_index_sequence<components_in<part>>();
    return {view_of_components<part>(a, 0, stride, components),
            view_of_components<part>(a, components_in<part>, stride, components)};
}
template <class View, class T> View view_of(const array<T> &a) { return view_of<View>(a, a.stride()); }

template <class T> typename api<T>::const_motors packed_motors(const T *first)
{
    using motor = typename api<T>::motor;
    return api<T>::const_motors_aos(reinterpret_cast<const motor *>(first), sizeof(motor));
}

} // namespace motorway::bench
