#include "kernels.h"

#include "api.h"

#include <memory>
#include <utility>

namespace motorway::bench {
namespace {

template <class T> const auto *fixed_motors(const std::vector<T> &components)
{
    return reinterpret_cast<const typename api<T>::motor *>(components.data());
}

// -------------------------------------------------------------------------------------------------------- verbs
//
// Of each verb a template over what it works on and how: the arguments, and bind, which makes the call.

enum class pairing { one, each, grid, indexed };

template <operand O, pairing P, unsigned Flags> struct apply {
    static bench::arguments arguments()
    {
        bench::arguments result{O, {O}};
        result.motor_an_element = P == pairing::each;
        result.index_an_element = P == pairing::indexed;
        result.fixed = P == pairing::each ? 0 : P == pairing::one ? 1 : shared_motors;
        result.images = P == pairing::grid ? shared_motors : 1;
        return result;
    }

    template <class T, class M> static work bind(const problem<T, M> &p)
    {
        using functions = apply_functions<O, T, M>;
        const auto in = view_of<typename functions::const_view>(p.in[0]);
        const auto out = view_of<typename functions::view>(p.out);
        const auto *const shared = fixed_motors(p.fixed);
        const std::size_t count = p.count;
        if constexpr (P == pairing::one)
            return make_work([=] { require(functions::one(out, shared, in, count, Flags)); });
        else if constexpr (P == pairing::each) {
            const auto motors = view_of<typename api<M>::const_motors>(*p.motors);
            return make_work([=] { require(functions::each(out, motors, in, count, Flags)); });
        } else if constexpr (P == pairing::grid)
            return bind_grid<functions>(p);
        else {
            const mw_indices indices = mw_indices_u16(p.indices.data(), sizeof p.indices[0]);
            return make_work([=] {
                require(functions::indexed(out, shared, shared_motors, indices, in, count, Flags));
            });
        }
    }

private:
    template <class functions, class T, class M> static work bind_grid(const problem<T, M> &p)
    {
        const bool columns = p.kind == layout::columns;
        const std::size_t step = p.out.stride(), count = p.count;
        const auto motors = packed_motors<M>(p.fixed.data());
        const auto in = view_of<typename functions::const_view>(p.in[0]);
        const auto out = view_of<typename functions::view>(p.out, columns ? shared_motors * step : step);
        const std::size_t row_stride = columns ? step : count * step;
        return make_work([=] {
            require(functions::grid(out, row_stride, motors, shared_motors, in, count, Flags));
        });
    }
};

template <operand, pairing, unsigned Flags> struct compose;
template <> struct compose<operand::motor, pairing::each, MW_DEFAULT> {
    static bench::arguments arguments() { return {operand::motor, {operand::motor, operand::motor}}; }

    template <class T> static work bind(const problem<T> &p)
    {
        using views = api<T>;
        const auto first = view_of<typename views::const_motors>(p.in[0]);
        const auto then = view_of<typename views::const_motors>(p.in[1]);
        return make_work([=, out = view_of<typename views::motors>(p.out), count = p.count] {
            require(views::compose_motor_each(out, first, then, count));
        });
    }
};

template <operand, pairing, unsigned Flags> struct reverse;
template <> struct reverse<operand::motor, pairing::each, MW_DEFAULT> {
    static bench::arguments arguments() { return {operand::motor, {operand::motor}}; }

    template <class T> static work bind(const problem<T> &p)
    {
        const auto in = view_of<typename api<T>::const_motors>(p.in[0]);
        return make_work([=, out = view_of<typename api<T>::motors>(p.out), count = p.count] {
            require(api<T>::reverse_motor_each(out, in, count));
        });
    }
};

template <operand, pairing, unsigned Flags> struct normalize;
template <> struct normalize<operand::motor, pairing::each, MW_DEFAULT> {
    static bench::arguments arguments() { return {operand::motor, {operand::motor}, motors::multiples}; }

    template <class T> static work bind(const problem<T> &p)
    {
        const auto in = view_of<typename api<T>::const_motors>(p.in[0]);
        return make_work([=, out = view_of<typename api<T>::motors>(p.out), count = p.count] {
            require(api<T>::normalize_motor_each(out, in, count));
        });
    }
};

template <class T> typename api<T>::weights weights_of(const array<T> &a)
{
    return {const_cast<const T *const *>(a.component()), a.stride()};
}

template <operand, pairing, unsigned Flags> struct blend;
template <> struct blend<operand::motor, pairing::one, MW_DEFAULT> {
    static bench::arguments arguments()
    {
        return {operand::motor, {operand::weights}, motors::unit, blend_terms};
    }

    template <class T> static work bind(const problem<T> &p)
    {
        return make_work([out = view_of<typename api<T>::motors>(p.out), controls = fixed_motors(p.fixed),
                          weights = weights_of(p.in[0]), count = p.count] {
            require(api<T>::blend_motor_one(out, controls, weights, blend_terms, count));
        });
    }
};

template <> struct blend<operand::motor, pairing::each, MW_DEFAULT> {
    static bench::arguments arguments()
    {
        bench::arguments result{operand::motor, {operand::weights}};
        result.in.insert(result.in.end(), blend_terms, operand::motor);
        return result;
    }

    template <class T> static work bind(const problem<T> &p)
    {
        using control_views = std::vector<typename api<T>::const_motors>;
        const auto controls = std::make_shared<control_views>();
        for (std::size_t k = 0; k < blend_terms; ++k)
            controls->push_back(view_of<typename api<T>::const_motors>(p.in[1 + k]));
        return make_work([=, out = view_of<typename api<T>::motors>(p.out), weights = weights_of(p.in[0]),
                          count = p.count] {
            require(api<T>::blend_motor_each(out, controls->data(), weights, blend_terms, count));
        });
    }
};

// --------------------------------------------------------------------------------------------------------- rows

template <class Kernel> kernel_row make_row(const char *verb, const std::string &name, std::size_t operations)
{
    return {verb, name, operations, Kernel::arguments(), std::string(verb) == "blend" ? blend_terms : 1};
}

template <class Kernel>
kernel_row make_row_of_both(const char *verb, const std::string &name, std::size_t operations)
{
    kernel_row row = make_row<Kernel>(verb, name, operations);
    row.f32 = Kernel::bind;
    row.f64 = Kernel::bind;
    return row;
}

template <class Kernel> kernel_row make_mixed_row(const char *verb, const std::string &name, std::size_t operations)
{
    kernel_row row = make_row<Kernel>(verb, name, operations);
    row.mixed = Kernel::bind;
    return row;
}

} // namespace

const std::vector<kernel_row> &kernel_rows()
{
#define MOTORWAY_KERNEL(verb, type, how, inputs, outputs, operations, divisions)                                     \
    make_row_of_both<verb<operand::type, pairing::how, MW_DEFAULT>>(#verb, #verb "_" #type "_" #how, operations),
#define MOTORWAY_KERNEL_UNIT(verb, type, how, inputs, outputs, operations, divisions)                                \
    make_row_of_both<verb<operand::type, pairing::how, MW_UNIT_MOTORS>>(#verb, #verb "_" #type "_" #how "-unit",     \
                                                                        operations),
#define MOTORWAY_KERNEL_MIXED(verb, type, how, inputs, outputs, operations, divisions)                               \
    make_mixed_row<verb<operand::type, pairing::how, MW_DEFAULT>>(#verb, #verb "_" #type "_" #how, operations),
    static const std::vector<kernel_row> rows = {
#include "../generated/kernel_list.inc"
    };
    return rows;
}

} // namespace motorway::bench
