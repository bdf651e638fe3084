// The call of a C function on the data of a problem: what is passed for a parameter follows from its type.
#pragma once

#include "api.h"
#include "work.h"

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace motorway::bench {

// What functions take beside arrays.
struct constants {
    unsigned flags = MW_DEFAULT;
    mw_euler_order order = MW_EULER_XYZ;
};
constexpr int unit_of_length = 2;

template <class T> const typename api<T>::motor *fixed_motors(const std::vector<T> &components)
{
    return reinterpret_cast<const typename api<T>::motor *>(components.data());
}

inline mw_matrix_layout matrix_layout(operand operand)
{
    switch (operand) {
    case operand::rows_4x4: return MW_MATRIX_ROWS_4X4;
    case operand::columns_3x4: return MW_MATRIX_COLUMNS_3X4;
    case operand::columns_4x4: return MW_MATRIX_COLUMNS_4X4;
    default: return MW_MATRIX_ROWS_3X4;
    }
}

// Whether a view is one of constants: an input.
template <class View, class T, class = void> constexpr bool is_input = false;
template <class View, class T>
constexpr bool is_input<View, T, std::void_t<decltype(View{std::declval<const T *>()})>> = true;

template <class View, class = void> constexpr bool is_of_matrices = false;
template <class View> constexpr bool is_of_matrices<View, std::void_t<decltype(View::layout)>> = true;

template <class T> class parameters {
public:
    parameters(const problem<T> &problem, const arguments &arguments, const constants &constants)
        : problem_(problem), arguments_(arguments), constants_(constants), size_(problem.count)
    {
    }

    // That of the next parameter, which is of type P. Arrays are taken in their order.
    template <class P> P next()
    {
        if constexpr (std::is_same_v<P, unsigned>)
            return constants_.flags;
        else if constexpr (std::is_same_v<P, mw_euler_order>)
            return constants_.order;
        else if constexpr (std::is_same_v<P, T>)
            return unit_of_length;
        else if constexpr (std::is_same_v<P, std::size_t *>) // where the number of the first bad element would go
            return nullptr;
        else if constexpr (std::is_same_v<P, const typename api<T>::motor *>)
            return fixed_motors(problem_.fixed) + fixed_++;
        else if constexpr (std::is_same_v<P, std::size_t>)
            return std::exchange(size_, problem_.count);
        else if constexpr (std::is_same_v<P, const T *>) { // and their stride is the size that follows
            const array<T> &numbers = problem_.in[in_++];
            size_ = numbers.stride();
            return numbers.component()[0];
        } else if constexpr (is_input<P, T>) {
            const std::size_t i = in_++;
            return view<P>(problem_.in[i], arguments_.in[i]);
        } else {
            const std::size_t i = out_++;
            return view<P>(problem_.out[i], arguments_.out[i]);
        }
    }

private:
    template <class View> static View view(const array<T> &array, operand operand)
    {
        if constexpr (is_of_matrices<View>)
            return {array.component()[0], array.stride(), matrix_layout(operand)};
        else
            return view_of<View>(array);
    }

    const problem<T> &problem_;
    const arguments &arguments_;
    const constants &constants_;
    std::size_t in_ = 0, out_ = 0, fixed_ = 0, size_;
};

template <class T, class... P>
work make_call(mw_status (*function)(P...), const problem<T> &problem, const arguments &arguments,
               const constants &constants)
{
    parameters<T> parameters(problem, arguments, constants);
    // In braces: one after the other.
    const std::tuple<std::decay_t<P>...> values{parameters.template next<std::decay_t<P>>()...};
    return make_work([=] { require(std::apply(function, values)); });
}

// How many motors that all elements share a function takes.
template <class... P> constexpr std::size_t fixed_motors_of(mw_status (*)(P...))
{
    return (std::size_t(std::is_same_v<P, const mw_motor_f32 *>) + ... + 0);
}

} // namespace motorway::bench
