// Angles: about an axis, in three Euler angles, and of screws. The bounds are those of docs/accuracy.md.
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
using Xyz = typename api<T>::xyz;
template <class T>
using ConstXyz = typename api<T>::const_xyz;

template <class T>
void draw_any_motor(Random &random, void *const *inputs)
{
    Draw<T>(random).motor(static_cast<T *>(inputs[0]));
    Draw<T>(random).spoil(static_cast<T *>(inputs[0]), 8);
}

template <class T>
void near_translation(Verdict &verdict, const T *numbers, const Motor<Wide<T>> &motor)
{
    const Vector<Wide<T>> right = translation(motor);
    const Wide<T> components[] = {right.x, right.y, right.z};
    verdict.near("translation", numbers, components, 3, reach(motor), 4, Wide<T>(16));
}

// The number nearest to π, which angles of rotations do not exceed.
template <class T>
T a_half_turn()
{
    return static_cast<T>(pi<Wide<T>>());
}

// Two quaternions of the same rotation, up to their sign.
template <class R>
Quaternion<R> with_sign_of(const Quaternion<R> &q, const Quaternion<R> &like)
{
    return dot(q, like) < 0 ? R(-1) * q : q;
}

// The rotation of numbers that were computed, against the right one: errors of the quaternion, in epsilons.
template <class T>
void near_rotation(Verdict &verdict, const Quaternion<Wide<T>> &computed, const Quaternion<Wide<T>> &right,
                   double bound)
{
    using R = Wide<T>;
    const Quaternion<R> same = with_sign_of(right, computed);
    const R off = length(computed + R(-1) * same) / epsilon<T>();
    verdict.at_most("rotation", is_finite(off) ? static_cast<double>(off) : HUGE_VAL, bound);
}

template <class T>
void near_pose(Verdict &verdict, const T *out, const Quaternion<Wide<T>> &r, const Vector<Wide<T>> &t,
               double rotation_bound, double translation_bound)
{
    using R = Wide<T>;
    near_motor(verdict, out, pose(r, t), R(1), rotation_bound, R(length(t) / 2), translation_bound, R(16));
}

// ---------------------------------------------------------------------------------------------------- axis and angle

template <class T>
Function axis_angle_to_motor()
{
    Function f{
        "axis and angle", named<T>("convert_axis_angle_to_motor_each"), {{7, sizeof(T)}}, motors_of<T>(), {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) {
        Draw<T> draw(random);
        T *const in = static_cast<T *>(inputs[0]);
        const auto axis = draw.axis();
        draw.vector(in, 7);
        in[0] = static_cast<T>(axis.x), in[1] = static_cast<T>(axis.y), in[2] = static_cast<T>(axis.z);
        in[3] = draw.angle();
        draw.spoil(in, 7);
    };
    f.ways = {[](const Call &call) {
        return C<T>::convert_axis_angle_to_motor_each(view_of<Out<T>>(call.out), view_of<typename C<T>::const_xyzw>(call.in[0]),
                                         view_of<ConstXyz<T>>(call.in[0], 4), call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        const T *const in = numbers<T>(inputs[0]);
        if (!judgeable<T>(in, 7))
            return verdict;
        const Quaternion<R> r = turn_about(vector_of<R>(in), R(R(in[3]) / 2));
        unit_motor(verdict, numbers<T>(out), 6);  // two of them are those of an axis rounded
        near_pose<T>(verdict, numbers<T>(out), r, vector_of<R>(in + 4), 2.5, 5);
        return verdict;
    };
    return f;
}

template <class T>
Function motor_to_axis_angle()
{
    Function f{"axis and angle",
               named<T>("convert_motor_to_axis_angle_each"),
               {motors_of<T>()},
               {7, sizeof(T)},
               draw_any_motor<T>,
               {},
               {}};
    f.ways = {[](const Call &call) {
        return C<T>::convert_motor_to_axis_angle_each(view_of<typename C<T>::xyzw>(call.out), view_of<Xyz<T>>(call.out, 4),
                                         view_of<In<T>>(call.in[0]), call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict = of_any_length<T>();
        const T *const got = numbers<T>(out);
        if (!usable_motor<T>(inputs[0]))
            return verdict;
        const auto motor = motor_of<R>(numbers<T>(inputs[0]));
        const R size = length(motor.r), sine = length(motor.r.v), angle = 2 * atan2(sine, abs(motor.r.w));
        if (got[3] != 0 || angle > scaled(R(1), -600))  // a double that small is none
            verdict.near("angle", got + 3, &angle, 1, angle, 4);
        verdict.require("angle in [0, pi]", got[3] >= 0 && got[3] <= a_half_turn<T>());
        const R off = abs(R(length(vector_of<R>(got)) - 1)) / epsilon<T>();
        verdict.at_most("length of the axis", is_finite(off) ? static_cast<double>(off) : HUGE_VAL, 3);
        if (got[3] == 0)
            verdict.require("the axis of no rotation is z", got[0] == 0 && got[1] == 0 && got[2] == 1);
        near_rotation<T>(verdict, turn_about(vector_of<R>(got), R(R(got[3]) / 2)), R(1 / size) * motor.r, 5);
        near_translation(verdict, got + 4, motor);
        return verdict;
    };
    return f;
}

// ------------------------------------------------------------------------------------------------------- Euler angles

template <class R>
Vector<R> unit(std::size_t axis)
{
    return {R(axis == 0), R(axis == 1), R(axis == 2)};
}

// Axes that turn along: the last acts first.
template <class T>
Quaternion<Wide<T>> rotation_of(mw_euler_order order, const T *angles)
{
    using R = Wide<T>;
    Quaternion<R> r{{}, 1};
    for (std::size_t k = 0; k < 3; ++k)
        r = r * turn_about(unit<R>(testing::axis_of(order, k)), R(R(angles[k]) / 2));
    return r;
}

// Half of how far the second angle is from gimbal lock, of a motor of any length. With w and q_i q_j q_k along the
// three axes: the smaller of the lengths of (w, q_i) and (q_j, q_k) if the first axis is the last; else of (w + q_j,
// q_i + q_k) and (w - q_j, q_i - q_k) over √2, where k is the axis that is left and counts with the sign of the order.
template <class R>
R distance_from_lock(mw_euler_order order, const Quaternion<R> &r)
{
    const R q[] = {r.v.x, r.v.y, r.v.z};
    const std::size_t i = testing::axis_of(order, 0), j = testing::axis_of(order, 1), k = 3 - i - j;
    const R size = length(r), sign = (i + 1) % 3 == j ? R(1) : R(-1);
    const auto both = [](R a, R b) { return sqrt(a * a + b * b); };
    if (i == testing::axis_of(order, 2))
        return smaller(both(r.w, q[i]), both(q[j], q[k])) / size;
    const R plus = both(r.w + q[j], q[i] + sign * q[k]), minus = both(r.w - q[j], q[i] - sign * q[k]);
    return smaller(plus, minus) / (size * sqrt(R(2)));
}

template <class T>
Function euler_to_motor(mw_euler_order order)
{
    Function f{"Euler",
               named<T>("convert_euler_to_motor_each") + ", " + testing::names_of_orders[order],
               {{6, sizeof(T)}},
               motors_of<T>(),
               {},
               {},
               {}};
    f.draw = [](Random &random, void *const *inputs) {
        Draw<T> draw(random);
        T *const in = static_cast<T *>(inputs[0]);
        draw.vector(in, 6);
        for (int k = 0; k < 3; ++k)
            in[k] = draw.angle();
        draw.spoil(in, 6);
    };
    f.ways = {[order](const Call &call) {
        return C<T>::convert_euler_to_motor_each(view_of<Out<T>>(call.out), view_of<ConstXyz<T>>(call.in[0]),
                                    view_of<ConstXyz<T>>(call.in[0], 3), call.count, order);
    }};
    f.judge = [order](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        const T *const in = numbers<T>(inputs[0]);
        if (!judgeable<T>(in, 6))
            return verdict;
        unit_motor(verdict, numbers<T>(out));
        near_pose<T>(verdict, numbers<T>(out), rotation_of(order, in), vector_of<R>(in + 3), 4, 5);
        return verdict;
    };
    return f;
}

// Motors of three angles, the second of them often one where the axes of the others meet.
template <class T>
void draw_for_euler(Random &random, mw_euler_order order, T *components)
{
    using R = Wide<T>;
    Draw<T> draw(random);
    if (draw.chance(2))
        return draw.motor(components);
    T angles[3];
    for (T &angle : angles)
        angle = draw.chance(4) ? T(0) : static_cast<T>(draw.uniform(-3.2, 3.2));
    const bool same_axes = testing::axis_of(order, 0) == testing::axis_of(order, 2);
    const double locked[] = {0, 3.14159265358979323846, -1.57079632679489661923, 1.57079632679489661923};
    angles[1] = static_cast<T>(locked[(same_axes ? 0u : 2u) + draw.below(2)]);
    if (draw.chance(2))
        angles[1] += draw.power_of_two(-60, -3);
    R exact[8];
    components_of(pose(rotation_of(order, angles), R(draw.usual()) * draw.axis()), exact);
    Draw<T>::round_to(components, exact, 8);
}

template <class T>
Function motor_to_euler(mw_euler_order order)
{
    Function f{"Euler",
               named<T>("convert_motor_to_euler_each") + ", " + testing::names_of_orders[order],
               {motors_of<T>()},
               {6, sizeof(T)},
               {},
               {},
               {}};
    f.draw = [order](Random &random, void *const *inputs) {
        draw_for_euler(random, order, static_cast<T *>(inputs[0]));
        Draw<T>(random).spoil(static_cast<T *>(inputs[0]), 8);
    };
    f.ways = {[order](const Call &call) {
        return C<T>::convert_motor_to_euler_each(view_of<Xyz<T>>(call.out), view_of<Xyz<T>>(call.out, 3),
                                    view_of<In<T>>(call.in[0]), call.count, order);
    }};
    f.judge = [order](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict = of_any_length<T>();
        const T *const got = numbers<T>(out);
        if (!usable_motor<T>(inputs[0]))
            return verdict;
        const auto motor = motor_of<R>(numbers<T>(inputs[0]));
        const bool same_axes = testing::axis_of(order, 0) == testing::axis_of(order, 2);
        const T half = a_half_turn<T>(), quarter = static_cast<T>(pi<R>() / 2);
        verdict.require("first and third in [-pi, pi]", std::fabs(got[0]) <= half && std::fabs(got[2]) <= half);
        verdict.require("second in its range",
                        same_axes ? got[1] >= 0 && got[1] <= half : std::fabs(got[1]) <= quarter);
        // How far the second angle is from where the axes of the others meet, half of it.
        const R off = distance_from_lock(order, motor.r) / epsilon<T>();
        near_rotation<T>(verdict, rotation_of(order, got), R(1 / length(motor.r)) * motor.r, off < R(10) ? 21 : 5);
        if (off < R(6))
            verdict.require("at gimbal lock the third angle is 0", got[2] == 0);
        near_translation(verdict, got + 3, motor);
        return verdict;
    };
    return f;
}

// ------------------------------------------------------------------------------------------------------------- screws

template <class T>
Function screw_to_motor()
{
    Function f{"screw", named<T>("convert_screw_to_motor_each"), {{8, sizeof(T)}}, motors_of<T>(), {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) {
        Draw<T> draw(random);
        T *const in = static_cast<T *>(inputs[0]);
        const auto axis = draw.axis();
        draw.vector(in, 8);
        in[0] = static_cast<T>(axis.x), in[1] = static_cast<T>(axis.y), in[2] = static_cast<T>(axis.z);
        in[6] = draw.angle();
        draw.spoil(in, 8);
    };
    f.ways = {[](const Call &call) {
        return C<T>::convert_screw_to_motor_each(view_of<Out<T>>(call.out), view_of<typename C<T>::const_screws>(call.in[0]),
                                    call.count);
    }};
    // docs/conventions.md: d = ½ h cos ½θ a + sin ½θ (p × a), and w = ½ h sin ½θ, of which dw is the opposite.
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict;
        const T *const in = numbers<T>(inputs[0]);
        if (!judgeable<T>(in, 8))
            return verdict;
        const Vector<R> a = vector_of<R>(in), p = vector_of<R>(in + 3);
        const Quaternion<R> r = turn_about(a, R(R(in[6]) / 2));
        const R h = R(in[7]) / 2, sine = sin(R(R(in[6]) / 2));
        const Motor<R> right{r, {(h * r.w) * a + sine * cross(p, a), -h * sine}};
        unit_motor(verdict, numbers<T>(out), 6);
        near_motor(verdict, numbers<T>(out), right, R(1), 2.5, R(abs(h) + length(p)), 5, R(16));
        return verdict;
    };
    return f;
}

template <class T>
Function motor_to_screw()
{
    Function f{
        "screw", named<T>("convert_motor_to_screw_each"), {motors_of<T>()}, {8, sizeof(T)}, draw_any_motor<T>, {}, {}};
    f.ways = {[](const Call &call) {
        return C<T>::convert_motor_to_screw_each(view_of<typename C<T>::screws>(call.out), view_of<In<T>>(call.in[0]), call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        using R = Wide<T>;
        Verdict verdict = of_any_length<T>();
        const T *const got = numbers<T>(out);
        if (!usable_motor<T>(inputs[0]))
            return verdict;
        const auto motor = motor_of<R>(numbers<T>(inputs[0]));
        const R angle = 2 * atan2(length(motor.r.v), abs(motor.r.w));
        verdict.require("angle in [0, pi]", got[6] >= 0 && got[6] <= a_half_turn<T>());
        if (angle > scaled(R(1), -58))
            verdict.near("angle", got + 6, &angle, 1, angle, 4);
        const R off = abs(R(length(vector_of<R>(got)) - 1)) / epsilon<T>();
        verdict.at_most("length of the axis", is_finite(off) ? static_cast<double>(off) : HUGE_VAL, 3);
        near_rotation<T>(verdict, turn_about(vector_of<R>(got), R(R(got[6]) / 2)), R(1 / length(motor.r)) * motor.r,
                         5);
        // What they move the origin by: (1 - R) p, and the distance along the axis.
        const Vector<R> a = vector_of<R>(got), p = vector_of<R>(got + 3);
        const Quaternion<R> q = turn_about(a, R(R(got[6]) / 2));
        const Vector<R> c = cross(q.v, p);  // R p is p + 2 w v × p + 2 v × (v × p)
        const Vector<R> moved = R(got[7]) * a - R(2) * (q.w * c + cross(q.v, c)), wrong = moved - translation(motor);
        const R size = reach(motor) + angle * length(p);
        if (size * headroom<T>() < largest<T>()) {
            const R lost = 16 * footroom<T>() * smallest<T>(), off_by = length(wrong);
            const R error = off_by <= lost ? R(0) : R((off_by - lost) / (epsilon<T>() * size));
            verdict.at_most("translation", is_finite(error) ? static_cast<double>(error) : HUGE_VAL, 8);
        }
        return verdict;
    };
    return f;
}

template <class T>
void add(Functions &functions)
{
    functions.push_back(axis_angle_to_motor<T>());
    functions.push_back(motor_to_axis_angle<T>());
    functions.push_back(screw_to_motor<T>());
    functions.push_back(motor_to_screw<T>());
    for (int order = 0; order <= static_cast<int>(MW_EULER_ZYZ); ++order) {
        functions.push_back(euler_to_motor<T>(static_cast<mw_euler_order>(order)));
        functions.push_back(motor_to_euler<T>(static_cast<mw_euler_order>(order)));
    }
}

}  // namespace

void add_angles(Functions &functions)
{
    add<float>(functions);
    add<double>(functions);
}

}  // namespace motorway::fuzz
