// Elements under motors: every operand, under one motor and under one each, and the pairings that give the same bits.
#include <cstdint>

#include "apply_api.h"
#include "judge.h"

namespace motorway::fuzz {
namespace {

using testing::ApplyCall;
using testing::ApplyFunctions;
using testing::Moved;
using testing::Pairing;

template <class T>
testing::View<T> at(const Place &place, std::size_t components)
{
    testing::View<T> view;
    for (std::size_t k = 0; k < components; ++k)
        view.component.push_back(reinterpret_cast<T *>(place.component[k]));
    view.stride = place.stride;
    return view;
}

// M is the number that motors are made of, T that of elements. Inputs are motors, elements, and of mixed functions a
// shift.
template <class M, class T>
struct Applying {
    ApplyFunctions<T> functions;
    unsigned flags;

    ApplyCall<T> arguments(const Call &call) const
    {
        ApplyCall<T> arguments;
        arguments.out = at<T>(call.out, functions.components());
        arguments.in = at<T>(call.in[1], functions.components());
        if (functions.is_mixed())
            arguments.shift = reinterpret_cast<const mw_shift *>(call.in[2].component[0]);
        arguments.count = call.count;
        arguments.flags = flags | (call.random.chance(3)   ? MW_STREAMING_STORES
                                   : call.random.chance(3) ? MW_NO_STREAMING_STORES
                                                           : MW_DEFAULT);
        return arguments;
    }

    mw_status one(const Call &call) const
    {
        ApplyCall<T> c = arguments(call);
        c.motor = call.in[0].component[0];
        return functions.run(Pairing::one, c);
    }

    // As one of the rows of a grid, whose motors are multiples of each other; rows one after the other, or side by
    // side.
    mw_status in_a_grid(const Call &call) const
    {
        ApplyCall<T> c = arguments(call);
        const std::size_t motor_count = 1 + call.random.below(5), row = call.random.below(motor_count);
        const std::size_t element = c.out.component.size() * sizeof(T);
        const bool rows = call.random.chance(2);
        std::vector<M> motors(8 * motor_count);
        for (std::size_t m = 0; m < motor_count; ++m)
            for (std::size_t k = 0; k < 8; ++k)
                motors[8 * m + k] = first_of<M>(call.in[0])[k] * (m == row ? 1 : 1 + static_cast<M>(m) / 8);
        std::vector<T> images(motor_count * call.count * c.out.component.size());
        Place out = call.out;
        for (std::size_t k = 0; k < c.out.component.size(); ++k)
            out.component[k] = reinterpret_cast<char *>(images.data() + k);
        out.stride = rows ? element : motor_count * element;
        c.row_stride = rows ? call.count * element : element;
        Place motors_at;
        for (std::size_t k = 0; k < 8; ++k)
            motors_at.component[k] = reinterpret_cast<char *>(motors.data() + k);
        motors_at.stride = 8 * sizeof(M);
        const testing::View<M> view = at<M>(motors_at, 8);
        c.motors = view.template as<T>();
        c.motor_count = motor_count;
        const std::size_t components = c.out.component.size();
        c.out = at<T>(out, components);
        const mw_status status = functions.run(Pairing::grid, c);
        for (std::size_t i = 0; i < call.count; ++i)
            for (std::size_t k = 0; k < components; ++k)
                std::memcpy(call.out.component[k] + i * call.out.stride,
                            out.component[k] + row * c.row_stride + i * out.stride, sizeof(T));
        return status;
    }

    mw_status each(const Call &call) const
    {
        ApplyCall<T> c = arguments(call);
        c.motors = at<M>(call.in[0], 8).template as<T>();
        return functions.run(Pairing::each, c);
    }

    // The same motors as a palette in any order.
    mw_status by_indices(const Call &call) const
    {
        ApplyCall<T> c = arguments(call);
        const std::size_t first = call.random.below(call.count), palette_count = call.count + call.random.below(3);
        std::vector<M> palette(8 * palette_count, M(1));
        std::vector<std::uint16_t> indices(call.count);
        for (std::size_t i = 0; i < call.count; ++i) {
            indices[i] = static_cast<std::uint16_t>((first + i) % call.count);
            for (std::size_t k = 0; k < 8; ++k)
                std::memcpy(&palette[8u * indices[i] + k], call.in[0].component[k] + i * call.in[0].stride, sizeof(M));
        }
        c.motor = palette.data();
        c.motor_count = palette_count;
        c.indices = mw_indices_u16(indices.data(), sizeof indices[0]);
        return functions.run(call.random.chance(2) ? Pairing::indexed : Pairing::indexed_checked, c);
    }
};

template <class T>
void draw_element(Random &random, Moved moved, T *components, std::size_t count)
{
    Draw<T> draw(random);
    if (moved == Moved::motor)
        draw.motor(components);
    else if (moved == Moved::bivector && draw.chance(2))
        draw.bivector(components);
    else
        draw.vector(components, count);
    draw.spoil(components, count);
}

// ------------------------------------------------------------------------------------------------------ what is right

template <class T>
Wide<T> largest_of(const T *numbers, std::size_t count)
{
    Wide<T> most = 0;
    for (std::size_t k = 0; k < count; ++k)
        most = larger(most, abs(Wide<T>(numbers[k])));
    return most;
}

// Rounding errors are relative to the lengths of the terms: of what is turned its own, and how far the motor reaches.
template <class T>
void judge_moved(Verdict &verdict, Moved moved, const Motor<Wide<T>> &motor, const T *in, std::size_t count,
                 const T *out)
{
    using R = Wide<T>;
    const R far = reach(motor), lost = 16 * (1 + far) * (1 + largest_of(in, count));
    const Vector<R> t = translation(motor);
    const auto near = [&](const char *what, const T *numbers, const Vector<R> &right, R scale, double bound) {
        const R components[] = {right.x, right.y, right.z};
        verdict.near(what, numbers, components, 3, scale, bound, lost);
    };
    const Vector<R> p = vector_of<R>(in), turned = rotate(motor, p);
    switch (moved) {
    case Moved::point:
    case Moved::vertex:
        near("point", out, turned + t, length(p) + far, 5);
        if (moved == Moved::vertex)
            near("normal", out + 3, rotate(motor, vector_of<R>(in + 3)), length(vector_of<R>(in + 3)), 5);
        break;
    case Moved::direction: near("direction", out, turned, length(p), 5); break;
    case Moved::tangent: {
        near("direction", out, turned, length(p), 5);
        const R w = in[3];
        verdict.near("w", out + 3, &w, 1, R(1), 0, R(0));
        break;
    }
    case Moved::vector: {
        if (far * far * headroom<T>() > largest<T>())
            break;
        const R e0 = in[0], ei = in[4];
        const Vector<R> middle = rotate(motor, vector_of<R>(in + 1));
        const R last = ei + dot(middle, t) + e0 * dot(t, t) / 2;
        verdict.near("e0", out, &e0, 1, R(1), 0, R(0));
        near("middle", out + 1, middle + e0 * t, length(middle) + abs(e0) * far, 5);
        verdict.near("e∞", out + 4, &last, 1, R(abs(ei) + length(middle) * far + abs(e0) * far * far), 8,
                     R(4 * lost * (1 + far)));
        break;
    }
    case Moved::line: {
        const Vector<R> moment = rotate(motor, vector_of<R>(in + 3)) + cross(t, turned);
        near("direction", out, turned, length(p), 5);
        near("moment", out + 3, moment, length(vector_of<R>(in + 3)) + length(p) * far, 8);
        break;
    }
    case Moved::motor:
    case Moved::bivector: {
        const Motor<R> m = moved == Moved::motor ? motor_of<R>(in) : bivector_of<R>(in);
        const Motor<R> right = compose(compose(inverse(motor), m), motor);
        // A multiple of 1 stays what it is, up to the rounding of the wide numbers.
        const R size = length(m.d) + length(m.r.v) * far + scaled(length(m.r) * far, -30);
        if (moved == Moved::motor)
            near_motor(verdict, out, right, length(m.r), 5, size, 8, lost);
        else
            near_bivector(verdict, out, right, length(m.r), 5, size, 8, lost);
        break;
    }
    }
}

// Computed in double and rounded once.
Verdict judge_mixed(const void *const *inputs, const void *out)
{
    Verdict verdict;
    const double *const shift = numbers<double>(inputs[2]);
    if (!judgeable<float>(inputs[1], 3) || !judgeable<double>(inputs[2], 6))
        return verdict;
    const Motor<Quad> motor = motor_of<Quad>(numbers<double>(inputs[0]));
    const Vector<Quad> p = vector_of<Quad>(numbers<float>(inputs[1])) - vector_of<Quad>(shift);
    const Vector<Quad> after = vector_of<Quad>(shift + 3), image = rotate(motor, p) + translation(motor) + after;
    const Quad size = length(p) + length(vector_of<Quad>(shift)) + reach(motor) + length(after);
    const long double right[] = {static_cast<long double>(image.x), static_cast<long double>(image.y),
                                 static_cast<long double>(image.z)};
    // Two errors in one number of epsilons of float: that of the one rounding, and that of doubles.
    const Quad scale = length(image) / 2 + 5 * (epsilon<double>() / Quad(epsilon<float>())) * size;
    if (size * headroom<double>() < largest<double>())
        verdict.near("point", numbers<float>(out), right, 3, static_cast<long double>(scale), 1.01);
    return verdict;
}

template <class M, class T>
Function application(Moved moved, Pairing pairing, unsigned flags)
{
    constexpr bool mixed = sizeof(M) != sizeof(T);
    const Applying<M, T> applying{testing::apply_functions_of<T>(moved, mixed), flags};
    const std::size_t components = applying.functions.components();
    const bool one = pairing == Pairing::one;
    Function f{"apply",
               applying.functions.name(pairing),
               {motors_of<M>(one ? Stream::shared : Stream::apart), {components, sizeof(T)}},
               {components, sizeof(T)},
               {},
               {},
               {}};
    if (flags)
        f.name += " of unit motors";
    if (mixed)
        f.inputs.push_back({6, sizeof(double), Stream::shared});
    f.draw = [=](Random &random, void *const *inputs) {
        M *const motor = static_cast<M *>(inputs[0]);
        flags ? Draw<M>(random).unit_motor(motor) : Draw<M>(random).motor(motor);
        if (!one)
            Draw<M>(random).spoil(motor, 8);
        draw_element(random, moved, static_cast<T *>(inputs[1]), components);
        if (mixed)
            for (int k = 0; k < 6; ++k)
                static_cast<double *>(inputs[2])[k] = random.chance(4) ? 0 : random.magnitude(1e-3, 1e12);
    };
    if (one)
        f.ways = {[=](const Call &call) { return applying.one(call); },
                  [=](const Call &call) { return applying.in_a_grid(call); }};
    else
        f.ways = {[=](const Call &call) { return applying.each(call); },
                  [=](const Call &call) { return applying.by_indices(call); }};
    f.judge = [=](const void *const *inputs, const void *out, bool) {
        Verdict verdict = flags ? Verdict() : of_any_length<T>();
        if (!usable_motor<M>(inputs[0]))
            return verdict;
        if constexpr (mixed) {
            return judge_mixed(inputs, out);
        } else {
            if (judgeable<T>(inputs[1], components) &&
                largest_of(numbers<T>(inputs[1]), components) * headroom<T>() <= largest<T>())
                judge_moved<T>(verdict, moved, motor_of<Wide<T>>(numbers<T>(inputs[0])), numbers<T>(inputs[1]),
                               components, numbers<T>(out));
            return verdict;
        }
    };
    return f;
}

template <class M, class T>
void add(Functions &functions, Moved moved)
{
    for (const Pairing pairing : {Pairing::one, Pairing::each})
        for (const unsigned flags : {unsigned(MW_DEFAULT), unsigned(MW_UNIT_MOTORS)})
            functions.push_back(application<M, T>(moved, pairing, flags));
}

}  // namespace

void add_applications(Functions &functions)
{
    for (const Moved moved : {Moved::point, Moved::direction, Moved::tangent, Moved::vertex, Moved::vector,
                              Moved::line, Moved::motor, Moved::bivector}) {
        add<float, float>(functions, moved);
        add<double, double>(functions, moved);
    }
    add<double, float>(functions, Moved::point);
}

}  // namespace motorway::fuzz
