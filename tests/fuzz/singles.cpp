// What is called one motor at a time: rotations, translations, and twists in their parts. A batch is a loop.
#include "convert_api.h"
#include "judge.h"

namespace motorway::fuzz {
namespace {

template <class T>
using C = testing::api<T>;

// In each element of a batch, from and to adjacent numbers.
template <class T>
mw_status for_each(const Call &call, std::size_t inputs, std::size_t outputs,
                   const std::function<mw_status(const T *in, T *out)> &function)
{
    for (std::size_t i = 0; i < call.count; ++i) {
        T in[most_components] = {}, out[most_components] = {};
        for (std::size_t k = 0; k < inputs; ++k)
            std::memcpy(in + k, call.in[0].component[k] + i * call.in[0].stride, sizeof(T));
        const mw_status status = function(in, out);
        if (status != MW_OK)
            return status;
        for (std::size_t k = 0; k < outputs; ++k)
            std::memcpy(call.out.component[k] + i * call.out.stride, out + k, sizeof(T));
    }
    return MW_OK;
}

template <class T>
Function rotation()
{
    Function f{"single", named<T>("rotation"), {{7, sizeof(T)}}, motors_of<T>(), {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) {
        Draw<T> draw(random);
        T *const in = static_cast<T *>(inputs[0]);
        do {
            draw.vector(in, 7);
            in[3] = draw.angle();
        } while (in[0] == 0 && in[1] == 0 && in[2] == 0);
    };
    f.ways = {[](const Call &call) {
        return for_each<T>(call, 7, 8, [](const T *in, T *out) {
            return api<T>::rotation(reinterpret_cast<typename api<T>::motor *>(out), in, in[3], in + 4);
        });
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        const T *const in = numbers<T>(inputs[0]);
        const Vector<R> axis = vector_of<R>(in), point = vector_of<R>(in + 4);
        const Quaternion<R> r = turn_about(R(1 / length(axis)) * axis, R(R(in[3]) / 2));
        const Motor<R> there = translator(point);
        const Motor<R> right = compose(compose(conjugate(there), Motor<R>{r, {}}), there);
        unit_motor(verdict, numbers<T>(out));
        near_motor(verdict, numbers<T>(out), right, R(1), sizeof(T) == 4 ? 1 : 3, length(point),
                   sizeof(T) == 4 ? 1 : 4);
        return verdict;
    };
    return f;
}

template <class T>
Function translation_by()
{
    Function f{"single", named<T>("translation"), {{3, sizeof(T)}}, motors_of<T>(), {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) { Draw<T>(random).vector(static_cast<T *>(inputs[0]), 3); };
    f.ways = {[](const Call &call) {
        return for_each<T>(call, 3, 8, [](const T *in, T *out) {
            return api<T>::translation(reinterpret_cast<typename api<T>::motor *>(out), in);
        });
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        Verdict verdict;
        near_motor(verdict, numbers<T>(out), translator(vector_of<Wide<T>>(numbers<T>(inputs[0]))), Wide<T>(1), 0,
                   Wide<T>(1), 0, Wide<T>(1));
        return verdict;
    };
    return f;
}

// axis, angle, along, across: with the axis, `along` makes half of what is along it, and `across` the rest.
template <class T>
Function split()
{
    Function f{"single", named<T>("split_bivector"), {{6, sizeof(T)}}, {10, sizeof(T)}, {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) { Draw<T>(random).bivector(static_cast<T *>(inputs[0])); };
    f.ways = {[](const Call &call) {
        return for_each<T>(call, 6, 10, [](const T *in, T *out) {
            return C<T>::split_bivector(reinterpret_cast<typename C<T>::twist *>(out), in);
        });
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        const T *const got = numbers<T>(out);
        const Motor<R> b = bivector_of<R>(numbers<T>(inputs[0]));
        const R half = length(b.r.v), angle = 2 * half, size = 2 * length(b.d.v);
        const Vector<R> axis = half == 0 ? Vector<R>{0, 0, 1} : R(1 / half) * b.r.v;
        const Vector<R> along = R(2 * dot(axis, b.d.v)) * axis, across = R(2) * b.d.v - along;
        const auto near = [&](const char *what, const T *numbers, const Vector<R> &right, R scale) {
            const R components[] = {right.x, right.y, right.z};
            verdict.near(what, numbers, components, 3, scale, sizeof(T) == 4 ? 1 : 4);
        };
        near("axis", got, axis, R(1));
        verdict.near("angle", got + 3, &angle, 1, angle, sizeof(T) == 4 ? 1 : 2);
        near("along", got + 4, along, size);
        near("across", got + 7, across, size);
        return verdict;
    };
    return f;
}

// Of the parts of a generator, and λ.
template <class T>
Function twist(bool position)
{
    const std::size_t outputs = position ? 3 : 8;
    Function f{"single",
               named<T>(position ? "twist_position" : "twist_pose"),
               {{11, sizeof(T)}},
               {outputs, sizeof(T)},
               {},
               {},
               {}};
    f.draw = [](Random &random, void *const *inputs) {
        using R = Wide<T>;
        Draw<T> draw(random);
        T *const in = static_cast<T *>(inputs[0]);
        const Vector<R> axis = draw.axis(), other = draw.axis();
        const R along = draw.distance(), across = draw.distance();
        Vector<R> normal = cross(axis, other);
        if (length(normal) < R(0.01))
            normal = {0, 0, 0};
        const R parts[] = {axis.x,
                           axis.y,
                           axis.z,
                           0,
                           along * axis.x,
                           along * axis.y,
                           along * axis.z,
                           across * normal.x,
                           across * normal.y,
                           across * normal.z};
        Draw<T>::round_to(in, parts, 10);
        in[3] = draw.angle();
        in[10] = draw.chance(2) ? static_cast<T>(draw.uniform(-2, 2)) : draw.usual();
        if (!Draw<T>::finite(in, 11))
            in[10] = 0;
    };
    f.ways = {[=](const Call &call) {
        return for_each<T>(call, 11, outputs, [=](const T *in, T *out) {
            const auto *const twist = reinterpret_cast<const typename C<T>::twist *>(in);
            return position ? C<T>::twist_position(out, twist, in[10])
                            : C<T>::twist_pose(reinterpret_cast<typename api<T>::motor *>(out), twist, in[10]);
        });
    }};
    f.judge = [=](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        const T *const in = numbers<T>(inputs[0]);
        const R lambda = in[10], half = lambda * R(in[3]) / 2;
        const Vector<R> axis = R(1 / length(vector_of<R>(in))) * vector_of<R>(in), along = vector_of<R>(in + 4),
                        across = vector_of<R>(in + 7);
        const Motor<R> b{{half * axis, R(0)}, {R(lambda / 2) * (along + across), R(0)}};
        const Motor<R> right = exp(b);
        const R size = abs(lambda) * (length(along) + length(across));
        // λ times the angle is rounded once.
        const R slack = 2 + 2 * abs(half) * (sizeof(T) == 4 ? epsilon<double>() / epsilon<T>() : R(1));
        const double bound = static_cast<double>(slack) + 2;
        if (abs(half) * 16 > largest<double>())
            return verdict;
        if (position) {
            const Vector<R> t = translation(right);
            const R components[] = {t.x, t.y, t.z};
            verdict.near("position", numbers<T>(out), components, 3, size, bound, R(16));
        } else {
            near_motor(verdict, numbers<T>(out), right, R(1), bound, size, bound, R(16));
        }
        return verdict;
    };
    return f;
}

template <class T>
void add(Functions &functions)
{
    functions.push_back(rotation<T>());
    functions.push_back(translation_by<T>());
    functions.push_back(split<T>());
    functions.push_back(twist<T>(false));
    functions.push_back(twist<T>(true));
}

}  // namespace

void add_singles(Functions &functions)
{
    add<float>(functions);
    add<double>(functions);
}

}  // namespace motorway::fuzz
