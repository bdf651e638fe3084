// Products of motors, their inverses, and normalising.
#include "judge.h"

namespace motorway::fuzz {
namespace {

template <class T>
using Out = typename api<T>::motors;
template <class T>
using In = typename api<T>::const_motors;

// Rounding errors of a product are relative to the products of the sizes of what is multiplied.
template <class T>
Verdict judge_product(const Motor<Wide<T>> &first, const Motor<Wide<T>> &then, const void *out, double rotation_bound,
                      double translation_bound, Wide<T> lost = 16, Verdict verdict = {})
{
    using R = Wide<T>;
    const R translation = length(first.r) * length(then.d) + length(first.d) * length(then.r);
    near_motor(verdict, numbers<T>(out), compose(first, then), length(first.r) * length(then.r), rotation_bound,
               translation, translation_bound, lost);
    return verdict;
}

// The product, and skeletons of two joints: the second is the first factor, and its parent the second.
template <class T>
mw_status along_a_hierarchy(const Call &call)
{
    std::vector<typename api<T>::motor> locals(2 * call.count);
    for (std::size_t k = 0; k < 8; ++k)
        for (std::size_t i = 0; i < call.count; ++i) {
            std::memcpy(&locals[i].s + k, call.in[1].component[k] + i * call.in[1].stride, sizeof(T));
            std::memcpy(&locals[call.count + i].s + k, call.in[0].component[k] + i * call.in[0].stride, sizeof(T));
        }
    const std::int32_t parents[] = {-1, 0};
    const std::size_t stride = sizeof locals[0];
    const mw_status status = api<T>::compose_motor_hierarchy(api<T>::motors_aos(locals.data(), stride),
                                                             api<T>::const_motors_aos(locals.data(), stride),
                                                             call.count * stride, parents, 2, call.count, nullptr);
    for (std::size_t k = 0; k < 8; ++k)
        for (std::size_t i = 0; i < call.count; ++i)
            std::memcpy(call.out.component[k] + i * call.out.stride, &locals[call.count + i].s + k, sizeof(T));
    return status;
}

enum class Same { none, first, then };  // which factor is the same for all

template <class T>
Function product(Same same)
{
    const char *const names[] = {"compose_motor_each", "compose_motor_one_first", "compose_motor_one_then"};
    Function f{"compose",
               named<T>(names[static_cast<int>(same)]),
               {motors_of<T>(same == Same::first ? Stream::shared : Stream::apart),
                motors_of<T>(same == Same::then ? Stream::shared : Stream::apart)},
               motors_of<T>(),
               {},
               {},
               {}};
    f.draw = [](Random &random, void *const *inputs) {
        for (int k = 0; k < 2; ++k) {
            Draw<T>(random).motor(static_cast<T *>(inputs[k]));
            Draw<T>(random).spoil(static_cast<T *>(inputs[k]), 8);
        }
    };
    f.ways = {[same](const Call &call) {
        const Out<T> out = view_of<Out<T>>(call.out);
        const auto one = [&](int k) {
            return reinterpret_cast<const typename api<T>::motor *>(call.in[k].component[0]);
        };
        const auto all = [&](int k) { return view_of<In<T>>(call.in[k]); };
        switch (same) {
        case Same::first: return api<T>::compose_motor_one_first(out, one(0), all(1), call.count);
        case Same::then: return api<T>::compose_motor_one_then(out, all(0), one(1), call.count);
        default: return api<T>::compose_motor_each(out, all(0), all(1), call.count);
        }
    }};
    if (same == Same::none)
        f.ways.push_back(along_a_hierarchy<T>);
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        if (!legal_motor<T>(inputs[0]) || !legal_motor<T>(inputs[1]))
            return Verdict();
        const auto first = motor_of<R>(numbers<T>(inputs[0])), then = motor_of<R>(numbers<T>(inputs[1]));
        return judge_product<T>(first, then, out, 2, 2.5);
    };
    return f;
}

template <class T>
Function ratio(unsigned flags)
{
    Function f{"ratio", named<T>("ratio_motor_each"), {motors_of<T>(), motors_of<T>()}, motors_of<T>(), {}, {}, {}};
    if (flags)
        f.name += " of unit motors";
    f.draw = [flags](Random &random, void *const *inputs) {
        Draw<T> draw(random);
        flags ? draw.unit_motor(static_cast<T *>(inputs[0])) : draw.motor(static_cast<T *>(inputs[0]));
        draw.motor(static_cast<T *>(inputs[1]));
        for (int k = 0; k < 2; ++k)
            draw.spoil(static_cast<T *>(inputs[k]), 8);
    };
    f.ways = {[flags](const Call &call) {
        return api<T>::ratio_motor_each(view_of<Out<T>>(call.out), view_of<In<T>>(call.in[0]),
                                        view_of<In<T>>(call.in[1]), call.count, flags);
    }};
    f.judge = [flags](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        if (!legal_motor<T>(inputs[0]) || !legal_motor<T>(inputs[1]))
            return Verdict();
        const auto from = motor_of<R>(numbers<T>(inputs[0])), to = motor_of<R>(numbers<T>(inputs[1]));
        // What is brought near 1 are motors to come from, and not those to come to.
        const R size = (1 + reach(from)) * length(to.r) + length(to.d);
        if (!flags && (!usable_motor<T>(inputs[0]) || size * headroom<T>() > largest<T>()))
            return Verdict();
        if (flags)
            return judge_product<T>(conjugate(from), to, out, 1.5, 2.5);
        // The product of both may underflow before it is divided by α.
        return judge_product<T>(inverse(from), to, out, 4, 8, larger(R(16), R(16) / alpha(from)), of_any_length<T>());
    };
    return f;
}

// ------------------------------------------------------------------------------------------------------ of one motor

template <class T>
Function of_one(const char *name, mw_status (*call_it)(const Out<T> &, const In<T> &, std::size_t),
                std::function<Verdict(const Motor<Wide<T>> &, const T *)> judge)
{
    Function f{name, named<T>((std::string(name) + "_motor_each").c_str()), {motors_of<T>()}, motors_of<T>(), {}, {},
               {}};
    f.draw = [](Random &random, void *const *inputs) {
        Draw<T>(random).motor(static_cast<T *>(inputs[0]));
        Draw<T>(random).spoil(static_cast<T *>(inputs[0]), 8);
    };
    f.ways = {[call_it](const Call &call) {
        return call_it(view_of<Out<T>>(call.out), view_of<In<T>>(call.in[0]), call.count);
    }};
    f.judge = [judge](const void *const *inputs, const void *out, bool) {
        return usable_motor<T>(inputs[0]) ? judge(motor_of<Wide<T>>(numbers<T>(inputs[0])), numbers<T>(out))
                                          : Verdict();
    };
    return f;
}

template <class T>
void add(Functions &functions)
{
    using R = Wide<T>;
    for (const Same same : {Same::none, Same::first, Same::then})
        functions.push_back(product<T>(same));
    functions.push_back(ratio<T>(MW_DEFAULT));
    functions.push_back(ratio<T>(MW_UNIT_MOTORS));
    functions.push_back(of_one<T>("reverse", api<T>::reverse_motor_each, [](const Motor<R> &m, const T *out) {
        Verdict verdict;
        near_motor(verdict, out, conjugate(m), R(1), 0, R(1), 0, R(0));
        return verdict;
    }));
    functions.push_back(of_one<T>("inverse", api<T>::inverse_motor_each, [](const Motor<R> &m, const T *out) {
        Verdict verdict = of_any_length<T>();
        near_motor(verdict, out, inverse(m), 1 / length(m.r), 3, length(m.d) / alpha(m), 9);
        return verdict;
    }));
    functions.push_back(of_one<T>("normalize", api<T>::normalize_motor_each, [](const Motor<R> &m, const T *out) {
        Verdict verdict = of_any_length<T>();
        unit_motor(verdict, out);
        near_motor(verdict, out, normalized(m), R(1), 1.5, reach(m) / 2, 4);
        return verdict;
    }));
}

}  // namespace

void add_products(Functions &functions)
{
    add<float>(functions);
    add<double>(functions);
}

}  // namespace motorway::fuzz
