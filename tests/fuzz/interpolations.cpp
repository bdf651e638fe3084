// slerp and nlerp, between a pair each and between the same pair; and weighted sums. The bounds are those of
// docs/accuracy.md.
#include "judge.h"

namespace motorway::fuzz {
namespace {

template <class T>
using Out = typename api<T>::motors;
template <class T>
using In = typename api<T>::const_motors;

struct Kind {
    bool along_a_screw, one;
    unsigned flags;
};

template <class T>
void draw_poses(Random &random, T *first, T *second)
{
    using R = Wide<T>;
    Draw<T> draw(random);
    draw.unit_motor(first);
    R exact[8];
    switch (draw.below(6)) {
    case 0: return draw.unit_motor(second);
    case 1:  // equal, or opposite
        for (int k = 0; k < 8; ++k)
            second[k] = first[k];
        break;
    default:
        components_of(compose(normalized(motor_of<R>(first)), draw.unit_motor()), exact);
        Draw<T>::round_to(second, exact, 8);
        if (!Draw<T>::finite(second, 8))
            return draw.unit_motor(second);
    }
    if (draw.chance(2))
        for (int k = 0; k < 8; ++k)
            second[k] = -second[k];
}

// Mostly within the range that is meant, and often at its ends.
template <class T>
T draw_parameter(Random &random)
{
    Draw<T> draw(random);
    switch (draw.below(8)) {
    case 0: return T(0);
    case 1: return T(1);
    case 2: return T(0.5);
    case 3: return static_cast<T>(draw.uniform(-1, 2));
    case 4: return draw.chance(2) ? draw.angle() : draw.number();
    case 5: return std::fabs(draw.power_of_two(-40, -2));
    default: return static_cast<T>(draw.uniform(0, 1));
    }
}

// Towards `end`, which is one of the two motors of the second pose.
template <class T>
Verdict judge_slerp(const Motor<Wide<T>> &first, const Motor<Wide<T>> &end, Wide<T> t, const T *out, bool fuses,
                    bool far)
{
    using R = Wide<T>;
    Verdict verdict;
    const Motor<R> right = slerp(first, end, t);
    const R size = larger(length(first.d), length(end.d));
    const R cosine = dot(normalized(first).r, normalized(end).r), sine_square = 1 - cosine * cosine;
    const bool within = t >= 0 && t <= 1, near = t >= -1 && t <= 2;
    const R times = larger(R(1), abs(t));
    if (far) {
        if (abs(t) * 8 > largest<T>())  // an angle that is not finite
            return verdict;
        unit_motor(verdict, out, 6);  // two of them are those of the pose that it begins at
        // Between poses that are the same, but for rounding or for 2^-40, there is no long way.
        if (sine_square < larger(64 * epsilon<T>() * epsilon<T>(), scaled(R(1), -78)))
            return verdict;
        // Half of the angle between them; what is promised below 0.1 of all is one over it.
        const R half = sqrt(sine_square);
        const double bound = half < R(0.05) ? static_cast<double>(1 / (2 * half)) : Bound(7, 8).of(fuses);
        near_motor(verdict, out, right, times, bound, R(times * times * size / sine_square),
                   larger(bound, (within ? Bound(6, 8) : Bound(10, 12)).of(fuses)), 64 / sine_square);
        return verdict;
    }
    if (!near)
        return verdict;
    unit_motor(verdict, out, within ? 5 : 10);  // up to two of them are those of the poses that it lies between
    near_motor(verdict, out, right, R(1), within ? 2.5 : Bound(5, 5).of(fuses),
               within ? size : larger(size, length(right.d)),
               within ? Bound(2.5, 3).of(fuses) : Bound(6, 6.5).of(fuses));
    return verdict;
}

template <class T>
Verdict judge_nlerp(const Motor<Wide<T>> &first, const Motor<Wide<T>> &end, Wide<T> t, const T *out)
{
    using R = Wide<T>;
    Verdict verdict;
    const Motor<R> sum = lerp(first, end, t), right = normalized(sum);
    const R gain = (abs(R(1 - t)) + abs(t)) / length(sum.r);  // by which rounding errors grow where the two cancel
    if (!(gain < R(2)) || length(sum.r) * (length(sum.r) + length(sum.d)) * 16 > largest<T>())
        return verdict;
    unit_motor(verdict, out);
    near_motor(verdict, out, right, R(gain), 1.5, R(larger(length(first.d), length(end.d)) * gain * gain), 2.5, R(16));
    return verdict;
}

template <class T>
Verdict judge_interpolation(const Kind &kind, const void *const *inputs, const void *out, bool fuses)
{
    using R = Wide<T>;
    if (!judgeable<T>(inputs[0], 8) || !judgeable<T>(inputs[1], 8) || !judgeable<T>(inputs[2], 1))
        return {};
    const auto first = motor_of<R>(numbers<T>(inputs[0])), second = motor_of<R>(numbers<T>(inputs[1]));
    const R t = *numbers<T>(inputs[2]), cosine = dot(first.r, second.r);
    const bool far = kind.flags & MW_LONG_WAY;
    const bool same = (cosine < 0) == far;
    const auto judge = [&](const Motor<R> &end) {
        return kind.along_a_screw ? judge_slerp<T>(first, end, t, numbers<T>(out), fuses, far)
                                  : judge_nlerp<T>(first, end, t, numbers<T>(out));
    };
    const Motor<R> opposite = R(-1) * second;
    const Verdict verdict = judge(same ? second : opposite);
    if (abs(cosine) > 8 * epsilon<T>())
        return verdict;
    return Verdict::better(verdict, judge(same ? opposite : second));
}

template <class T>
Function interpolation(const Kind &kind)
{
    const std::string verb = kind.along_a_screw ? "slerp" : "nlerp";
    const Stream::Kind poses = kind.one ? Stream::shared : Stream::apart;
    Function f{verb,
               named<T>((verb + "_motor_" + (kind.one ? "one" : "each")).c_str()),
               {motors_of<T>(poses), motors_of<T>(poses), {1, sizeof(T)}},
               motors_of<T>(),
               {},
               {},
               {}};
    if (kind.flags)
        f.name += ", the long way";
    f.draw = [kind](Random &random, void *const *inputs) {
        draw_poses(random, static_cast<T *>(inputs[0]), static_cast<T *>(inputs[1]));
        *static_cast<T *>(inputs[2]) = draw_parameter<T>(random);
        for (int k = 0; k < 3; ++k)
            if (k == 2 || !kind.one)
                Draw<T>(random).spoil(static_cast<T *>(inputs[k]), k == 2 ? 1 : 8);
    };
    f.ways = {[kind](const Call &call) {
        const T *const t = first_of<T>(call.in[2]);
        const Out<T> out = view_of<Out<T>>(call.out);
        if (kind.one) {
            using M = typename api<T>::motor;
            const auto function = kind.along_a_screw ? api<T>::slerp_motor_one : api<T>::nlerp_motor_one;
            return function(out, first_of<M>(call.in[0]), first_of<M>(call.in[1]), t, call.in[2].stride, call.count,
                            kind.flags);
        }
        const auto function = kind.along_a_screw ? api<T>::slerp_motor_each : api<T>::nlerp_motor_each;
        return function(out, view_of<In<T>>(call.in[0]), view_of<In<T>>(call.in[1]), t, call.in[2].stride, call.count,
                        kind.flags);
    }};
    f.judge = [kind](const void *const *inputs, const void *out, bool fuses) {
        return judge_interpolation<T>(kind, inputs, out, fuses);
    };
    return f;
}

// ------------------------------------------------------------------------------------------------------------ blends

// Weights first, as one stream, then the controls: all of them one palette, or a stream each.
template <class T>
Verdict judge_blend(std::size_t terms, const void *const *inputs, const void *out)
{
    using R = Wide<T>;
    Verdict verdict;
    if (!judgeable<T>(inputs[0], terms))
        return verdict;
    for (std::size_t c = 0; c < 8; ++c) {
        R sum = 0, size = 0;
        for (std::size_t k = 0; k < terms; ++k) {
            const T *const control = numbers<T>(inputs[1 + k]);
            if (!std::isfinite(control[c]))
                return verdict;
            const R term = R(numbers<T>(inputs[0])[k]) * R(control[c]);
            sum += term;
            size += abs(term);
        }
        verdict.near("sum", numbers<T>(out) + c, &sum, 1, size, static_cast<double>(terms + 1) / 2, R(2 * terms));
    }
    return verdict;
}

template <class T>
Function blend(std::size_t terms, bool one)
{
    Function f{"blend",
               named<T>(one ? "blend_motor_one" : "blend_motor_each") + " of " + std::to_string(terms),
               {{terms, sizeof(T)}},
               motors_of<T>(),
               {},
               {},
               {}};
    for (std::size_t k = 0; k < terms; ++k)
        f.inputs.push_back(motors_of<T>(one ? Stream::shared : Stream::apart));
    f.draw = [terms](Random &random, void *const *inputs) {
        for (std::size_t k = 0; k < terms; ++k) {
            static_cast<T *>(inputs[0])[k] = random.chance(2) ? static_cast<T>(random.uniform(0, 1))
                                                              : Draw<T>(random).number();
            Draw<T>(random).motor(static_cast<T *>(inputs[1 + k]));
        }
        Draw<T>(random).spoil(static_cast<T *>(inputs[0]), terms);
    };
    f.ways = {[terms, one](const Call &call) {
        std::vector<const T *> weights;
        for (std::size_t k = 0; k < terms; ++k)
            weights.push_back(reinterpret_cast<const T *>(call.in[0].component[k]));
        const typename api<T>::weights view{weights.data(), call.in[0].stride};
        if (one) {
            std::vector<typename api<T>::motor> palette;
            for (std::size_t k = 0; k < terms; ++k)
                palette.push_back(*first_of<typename api<T>::motor>(call.in[1 + k]));
            return api<T>::blend_motor_one(view_of<Out<T>>(call.out), palette.data(), view, terms, call.count);
        }
        std::vector<In<T>> controls;
        for (std::size_t k = 0; k < terms; ++k)
            controls.push_back(view_of<In<T>>(call.in[1 + k]));
        return api<T>::blend_motor_each(view_of<Out<T>>(call.out), controls.data(), view, terms, call.count);
    }};
    f.judge = [terms](const void *const *inputs, const void *out, bool) { return judge_blend<T>(terms, inputs, out); };
    return f;
}

template <class T>
void add(Functions &functions)
{
    for (const bool along_a_screw : {true, false})
        for (const bool one : {true, false})
            for (const unsigned flags : {unsigned(MW_DEFAULT), unsigned(MW_LONG_WAY)})
                functions.push_back(interpolation<T>({along_a_screw, one, flags}));
    for (const std::size_t terms : {1, 2, 4, 9})
        for (const bool one : {true, false})
            functions.push_back(blend<T>(terms, one));
}

}  // namespace

void add_interpolations(Functions &functions)
{
    add<float>(functions);
    add<double>(functions);
}

}  // namespace motorway::fuzz
