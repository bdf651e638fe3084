// The C API by precision: api<float>::compose_motor_each is mw_compose_motor_each_f32. And views of any number of
// components, which the testers lay out and turn into those of the API.
#ifndef MOTORWAY_TESTS_API_H
#define MOTORWAY_TESTS_API_H

#include <cstddef>
#include <vector>

#include "motorway_views.h"

namespace motorway::testing {

// api<T>, from the table of public functions.
#include "../generated/api.inc"

using scalar_f32 = float;
using scalar_f64 = double;

inline mw_status check_indices(const mw_indices &indices, std::size_t count, std::size_t palette_count,
                               std::size_t *first_bad)
{
    return mw_check_indices_views(&indices, count, palette_count, first_bad);
}

// Component k of element i is `stride` * i bytes behind component[k], and need not be aligned.
template <class T>
struct View {
    std::vector<T *> component;
    std::size_t stride = 0;

    typename api<T>::xyz xyz() const { return {component[0], component[1], component[2], stride}; }
    typename api<T>::const_xyz const_xyz() const { return {component[0], component[1], component[2], stride}; }

    typename api<T>::motors motors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], stride};
    }

    typename api<T>::const_motors const_motors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], stride};
    }

    typename api<T>::bivectors bivectors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], stride};
    }

    typename api<T>::const_bivectors const_bivectors() const
    {
        const auto &c = component;
        return {c[0], c[1], c[2], c[3], c[4], c[5], stride};
    }

    // The same bytes as components of another type.
    template <class U>
    View<U> as() const
    {
        View<U> view;
        for (T *pointer : component)
            view.component.push_back(reinterpret_cast<U *>(pointer));
        view.stride = stride;
        return view;
    }

    // The pointers are those of this view, which must live as long.
    typename api<T>::weights weights() const { return {const_cast<const T *const *>(component.data()), stride}; }
};

}  // namespace motorway::testing

#endif
