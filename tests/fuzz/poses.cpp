// Motors into and from other representations, without angles: poses, dual quaternions, matrices, translations, rotors.
#include "convert_api.h"
#include "judge.h"

namespace motorway::fuzz {
namespace {

template <class T>
using C = testing::api<T>;
template <class T>
using Out = typename api<T>::motors;
template <class T>
using In = typename api<T>::const_motors;

template <class T>
void draw_any_motor(Random &random, void *const *inputs)
{
    Draw<T>(random).motor(static_cast<T *>(inputs[0]));
    Draw<T>(random).spoil(static_cast<T *>(inputs[0]), 8);
}

template <class T>
void near_vector(Verdict &verdict, const char *what, const T *numbers, const Vector<Wide<T>> &right, Wide<T> scale,
                 double bound, Wide<T> lost)
{
    const Wide<T> components[] = {right.x, right.y, right.z};
    verdict.near(what, numbers, components, 3, scale, bound, lost);
}

// Where a motor takes the origin: relative to how far it reaches.
template <class T>
void near_translation(Verdict &verdict, const T *numbers, const Motor<Wide<T>> &motor)
{
    near_vector<T>(verdict, "translation", numbers, translation(motor), reach(motor), 4, 16);
}

// r and then a translation by t, of an r that need not be normalised.
template <class T>
void near_pose(Verdict &verdict, const T *out, const Quaternion<Wide<T>> &r, const Vector<Wide<T>> &t,
               double rotation_bound, double translation_bound)
{
    using R = Wide<T>;
    const R size = length(r);
    near_motor(verdict, out, pose(r, t), size, rotation_bound, R(size * length(t) / 2), translation_bound,
               R(16 * (1 + size)));
}

// ------------------------------------------------------------------------------------------------------------- poses

template <class T>
Function motor_to_pose()
{
    Function f{"pose", named<T>("convert_motor_to_pose_each"), {motors_of<T>()}, {7, sizeof(T)}, draw_any_motor<T>, {},
               {}};
    f.ways = {[](const Call &call) {
        return C<T>::convert_motor_to_pose_each(view_of<typename C<T>::xyzw>(call.out), view_of<typename api<T>::xyz>(call.out, 4),
                                   view_of<In<T>>(call.in[0]), call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict = of_any_length<T>();
        if (!usable_motor<T>(inputs[0]))
            return verdict;
        const auto motor = motor_of<R>(numbers<T>(inputs[0]));
        const Quaternion<R> q = R(1 / length(motor.r)) * motor.r;
        const R components[] = {q.v.x, q.v.y, q.v.z, q.w};
        verdict.near("quaternion", numbers<T>(out), components, 4, R(1), 2);
        near_translation(verdict, numbers<T>(out) + 4, motor);
        return verdict;
    };
    return f;
}

template <class T>
Function pose_to_motor()
{
    Function f{"pose", named<T>("convert_pose_to_motor_each"), {{7, sizeof(T)}}, motors_of<T>(), {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) {
        T *const in = static_cast<T *>(inputs[0]), motor[8] = {};
        Draw<T>(random).motor(const_cast<T *>(motor));
        Draw<T>(random).vector(in, 7);
        for (int k = 0; k < 4; ++k)
            in[k] = motor[3 - k];
        Draw<T>(random).spoil(in, 7);
    };
    f.ways = {[](const Call &call) {
        return C<T>::convert_pose_to_motor_each(view_of<Out<T>>(call.out), view_of<typename C<T>::const_xyzw>(call.in[0]),
                                   view_of<typename api<T>::const_xyz>(call.in[0], 4), call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        const T *const in = numbers<T>(inputs[0]);
        if (judgeable<T>(in, 7))
            near_pose<T>(verdict, numbers<T>(out), {vector_of<R>(in), R(in[3])}, vector_of<R>(in + 4), 0, 2.5);
        return verdict;
    };
    return f;
}

// --------------------------------------------------------------------------------------------------- dual quaternions

// The numbers of the one are those of the other in another order, but for the signs of two.
constexpr int places[] = {3, 2, 1, 0, 4, 5, 6, 7};
constexpr int signs[] = {1, -1, 1, 1, 1, 1, 1, -1};  // of rx ry rz rw dx dy dz dw

template <class T>
Function dual_quaternions(bool from_motors)
{
    Function f{
        "dual quaternion",
        named<T>(from_motors ? "convert_motor_to_dual_quaternion_each" : "convert_dual_quaternion_to_motor_each"),
        {motors_of<T>()},
        motors_of<T>(),
        draw_any_motor<T>,
        {},
        {}};
    f.ways = {[from_motors](const Call &call) {
        return from_motors ? C<T>::convert_motor_to_dual_quaternion_each(view_of<typename C<T>::dual_quaternions>(call.out),
                                                            view_of<In<T>>(call.in[0]), call.count)
                           : C<T>::convert_dual_quaternion_to_motor_each(view_of<Out<T>>(call.out),
                                                            view_of<typename C<T>::const_dual_quaternions>(call.in[0]),
                                                            call.count);
    }};
    f.judge = [from_motors](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        if (!judgeable<T>(inputs[0], 8))
            return verdict;
        for (int k = 0; k < 8; ++k) {
            const int from = places[k], sign = from_motors ? signs[k] : signs[from];
            const R right = R(sign) * R(numbers<T>(inputs[0])[from]);
            verdict.near("component", numbers<T>(out) + k, &right, 1, R(0), 0, R(0));
        }
        return verdict;
    };
    return f;
}

// ---------------------------------------------------------------------------------------------------------- matrices

template <class R>
Vector<R> column_of(const Quaternion<R> &r, int k)
{
    const Vector<R> unit{R(k == 0), R(k == 1), R(k == 2)};
    return rotate(Motor<R>{r, {}}, unit);
}

// Which of the numbers of a matrix are 0 0 0 1. They are looked at, but not converted.
unsigned last_row(mw_matrix_layout layout)
{
    unsigned numbers = (1u << testing::numbers_of(layout)) - 1;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            numbers &= ~(1u << testing::place_in_matrix(layout, row, column));
    return numbers;
}

template <class T>
Function motor_to_matrix(mw_matrix_layout layout)
{
    Function f{"matrix",
               named<T>("convert_motor_to_matrix_each") + ", " + testing::name_of(layout),
               {motors_of<T>()},
               {testing::numbers_of(layout), sizeof(T), Stream::adjacent},
               draw_any_motor<T>,
               {},
               {}};
    f.ways = {[layout](const Call &call) {
        const typename C<T>::matrices matrices{reinterpret_cast<T *>(call.out.component[0]), call.out.stride, layout};
        return C<T>::convert_motor_to_matrix_each(matrices, view_of<In<T>>(call.in[0]), call.count);
    }};
    f.judge = [layout](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict = of_any_length<T>();
        if (!usable_motor<T>(inputs[0]))
            return verdict;
        const auto motor = motor_of<R>(numbers<T>(inputs[0]));
        const auto near_column = [&](const char *what, std::size_t k, const Vector<R> &right, R scale) {
            T column[3];
            for (std::size_t row = 0; row < 3; ++row)
                column[row] = numbers<T>(out)[testing::place_in_matrix(layout, row, k)];
            near_vector<T>(verdict, what, column, right, scale, 4, 16);
        };
        for (int k = 0; k < 3; ++k)
            near_column("rotation", static_cast<std::size_t>(k), column_of(motor.r, k), R(1));
        near_column("translation", 3, translation(motor), reach(motor));
        for (std::size_t k = 0; k < testing::numbers_of(layout); ++k)
            if (last_row(layout) >> k & 1)
                verdict.require("last row", numbers<T>(out)[k] == T(k == 15));
        return verdict;
    };
    return f;
}

// Orthonormal to rounding, with translations of any size. The motor with s >= 0; at half turns either.
template <class T>
Function matrix_to_motor(mw_matrix_layout layout, unsigned flags)
{
    const bool unchecked = flags == MW_ROTATION_MATRICES;
    Function f{
        "matrix",
        named<T>("convert_matrix_to_motor_each") + ", " + testing::name_of(layout),
        {{testing::numbers_of(layout), sizeof(T), Stream::adjacent, unchecked ? last_row(layout) : 0}, motors_of<T>()},
        motors_of<T>(),
        {},
        {},
        {}};
    f.name += flags == MW_NEAREST_ROTATION ? ", nearest rotation" : unchecked ? ", unchecked" : "";
    // The second input is the motor that the matrix was made of, for the judge.
    f.draw = [layout, unchecked](Random &random, void *const *inputs) {
        using R = Wide<T>;
        Draw<T> draw(random);
        T *const matrix = static_cast<T *>(inputs[0]), *const motor = static_cast<T *>(inputs[1]);
        draw.unit_motor(motor);
        const auto exact = motor_of<R>(motor);
        for (std::size_t k = 0; k < testing::numbers_of(layout); ++k)
            matrix[k] = unchecked ? draw.number() : T(k == 15);
        for (std::size_t k = 0; k < 4; ++k) {
            const Vector<R> column = column_of(exact.r, static_cast<int>(k));
            T numbers[] = {static_cast<T>(column.x), static_cast<T>(column.y), static_cast<T>(column.z)};
            if (k == 3)
                draw.vector(numbers, 3);
            for (std::size_t row = 0; row < 3; ++row)
                matrix[testing::place_in_matrix(layout, row, k)] = numbers[row];
        }
    };
    f.ways = {[layout, flags](const Call &call) {
        return C<T>::convert_matrix_to_motor_each(view_of<Out<T>>(call.out), {first_of<T>(call.in[0]), call.in[0].stride, layout},
                                     call.count, flags, nullptr);
    }};
    f.judge = [layout, flags](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        const auto motor = motor_of<R>(numbers<T>(inputs[1]));
        const T *const matrix = numbers<T>(inputs[0]);
        const Vector<R> t{R(matrix[testing::place_in_matrix(layout, 0, 3)]),
                          R(matrix[testing::place_in_matrix(layout, 1, 3)]),
                          R(matrix[testing::place_in_matrix(layout, 2, 3)])};
        const auto judge = [&](R sign) {
            Verdict verdict;
            near_pose<T>(verdict, numbers<T>(out), R(sign / length(motor.r)) * motor.r, t, 3, 4);
            unit_motor(verdict, numbers<T>(out), flags == MW_NEAREST_ROTATION ? 6 : 4);
            return verdict;
        };
        const Verdict verdict = judge(motor.r.w < 0 ? R(-1) : R(1));
        return abs(motor.r.w) > 8 * epsilon<T>() ? verdict
                                                 : Verdict::better(verdict, judge(motor.r.w < 0 ? R(1) : R(-1)));
    };
    return f;
}

// ---------------------------------------------------------------------------------------------- translations and
// rotors

template <class T>
Function motor_to_translation()
{
    Function f{"translation",
               named<T>("convert_motor_to_translation_each"),
               {motors_of<T>()},
               {3, sizeof(T)},
               draw_any_motor<T>,
               {},
               {}};
    f.ways = {[](const Call &call) {
        return C<T>::convert_motor_to_translation_each(view_of<typename api<T>::xyz>(call.out), view_of<In<T>>(call.in[0]),
                                          call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        Verdict verdict = of_any_length<T>();
        if (usable_motor<T>(inputs[0]))
            near_translation<T>(verdict, numbers<T>(out), motor_of<Wide<T>>(numbers<T>(inputs[0])));
        return verdict;
    };
    return f;
}

template <class T>
Function translation_to_motor()
{
    Function f{
        "translation", named<T>("convert_translation_to_motor_each"), {{3, sizeof(T)}}, motors_of<T>(), {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) {
        Draw<T>(random).vector(static_cast<T *>(inputs[0]), 3);
        Draw<T>(random).spoil(static_cast<T *>(inputs[0]), 3);
    };
    f.ways = {[](const Call &call) {
        return C<T>::convert_translation_to_motor_each(view_of<Out<T>>(call.out), view_of<typename api<T>::const_xyz>(call.in[0]),
                                          call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        if (judgeable<T>(inputs[0], 3))
            near_motor(verdict, numbers<T>(out), translator(vector_of<R>(numbers<T>(inputs[0]))), R(1), 0, R(1), 0,
                       R(1));
        return verdict;
    };
    return f;
}

// The reverse, its second half over λ; and w / λ with the opposite sign, which is that of the reverse of dw.
template <class T>
Function rotors(bool from_motors, T lambda)
{
    Function f{"rotor",
               named<T>(from_motors ? "convert_motor_to_rotor_each" : "convert_rotor_to_motor_each"),
               {motors_of<T>()},
               motors_of<T>(),
               draw_any_motor<T>,
               {},
               {}};
    f.ways = {[=](const Call &call) {
        return from_motors
                   ? C<T>::convert_motor_to_rotor_each(view_of<Out<T>>(call.out), view_of<In<T>>(call.in[0]), call.count, lambda)
                   : C<T>::convert_rotor_to_motor_each(view_of<Out<T>>(call.out), view_of<In<T>>(call.in[0]), call.count, lambda);
    }};
    f.judge = [=](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        if (!judgeable<T>(inputs[0], 8))
            return verdict;
        const R factor = from_motors ? 1 / R(lambda) : R(lambda);
        for (int k = 0; k < 8; ++k) {
            const R sign = k == 0 || k == 7 ? R(1) : R(-1);
            const R right = sign * (k < 4 ? R(1) : factor) * R(numbers<T>(inputs[0])[k]);
            verdict.near("component", numbers<T>(out) + k, &right, 1, abs(right), k < 4 ? 0 : 1.01, R(k < 4 ? 0 : 4));
        }
        return verdict;
    };
    return f;
}

template <class T>
void add(Functions &functions)
{
    functions.push_back(motor_to_pose<T>());
    functions.push_back(pose_to_motor<T>());
    for (const bool from_motors : {true, false}) {
        functions.push_back(dual_quaternions<T>(from_motors));
        functions.push_back(rotors<T>(from_motors, T(0.37)));
    }
    for (const mw_matrix_layout layout : testing::all_matrix_layouts) {
        functions.push_back(motor_to_matrix<T>(layout));
        for (const unsigned flags :
             {unsigned(MW_DEFAULT), unsigned(MW_ROTATION_MATRICES), unsigned(MW_NEAREST_ROTATION)})
            functions.push_back(matrix_to_motor<T>(layout, flags));
    }
    functions.push_back(motor_to_translation<T>());
    functions.push_back(translation_to_motor<T>());
}

}  // namespace

void add_poses(Functions &functions)
{
    add<float>(functions);
    add<double>(functions);
}

}  // namespace motorway::fuzz
