// exp, log, roots and powers. The bounds are those of docs/accuracy.md.
#include "judge.h"

namespace motorway::fuzz {
namespace {

// About one axis of coordinates the angle is exactly that which is given, and so must its sine and cosine be. About
// any other it is the root of a sum: to a few epsilons as long as these do not make it another angle, and else to one
// of its own.
template <class R>
R angle_slack(const Motor<R> &b, R half_angle)
{
    const Vector<R> &v = b.r.v;
    const int components = (v.x != 0) + (v.y != 0) + (v.z != 0);
    return components < 2 || half_angle < R(5e5) ? R(0) : half_angle;
}

template <class T>
Verdict judge_exp(const void *const *inputs, const void *out, bool fuses)
{
    using R = Wide<T>;
    Verdict verdict;
    if (!judgeable<T>(inputs[0], 6))
        return verdict;
    const Motor<R> b = bivector_of<R>(numbers<T>(inputs[0]));
    const R half = length(b.r.v), moment = length(b.d.v), slack = angle_slack(b, half);
    const Motor<R> right = exp(b);
    const bool to_a_half_turn = half <= pi<R>() / 2;
    const Bound rotation = to_a_half_turn ? Bound(2.5) : Bound(3.5, 5);
    const Bound translation = to_a_half_turn ? Bound(3) : Bound(4.5, 5.5);
    const double more = static_cast<double>(slack);
    unit_motor(verdict, numbers<T>(out));
    near_motor(verdict, numbers<T>(out), right, R(1), rotation.of(fuses) + more,
               to_a_half_turn ? length(right.d) : moment, translation.of(fuses) + more);
    return verdict;
}

template <class T>
Function exponential()
{
    Function f{"exp", named<T>("exp_motor_each"), {{6, sizeof(T)}}, motors_of<T>(), {}, {}, judge_exp<T>};
    f.draw = [](Random &random, void *const *inputs) {
        T *const bivector = static_cast<T *>(inputs[0]);
        Draw<T>(random).bivector(bivector);
        Draw<T>(random).spoil(bivector, 6);
    };
    f.ways = {[](const Call &call) {
        return api<T>::exp_motor_each(view_of<typename api<T>::motors>(call.out),
                                      view_of<typename api<T>::const_bivectors>(call.in[0]), call.count);
    }};
    return f;
}

// ------------------------------------------------------------------------------------------------------- logarithms

enum class Given { unit, any };

template <class T>
auto draw_motor(Given given)
{
    return [given](Random &random, void *const *inputs) {
        T *const motor = static_cast<T *>(inputs[0]);
        given == Given::unit ? Draw<T>(random).unit_motor(motor) : Draw<T>(random).motor(motor);
        Draw<T>(random).spoil(motor, 8);
    };
}

// Half turns have two shortest logarithms, and those that are not quite may be either.
template <class T, class Judge>
Verdict either_sign(const Motor<Wide<T>> &motor, const Judge &judge)
{
    const Verdict verdict = judge(motor);
    if (abs(motor.r.w) > 4 * epsilon<T>() * length(motor.r))
        return verdict;
    return Verdict::better(verdict, judge(Wide<T>(-1) * motor));
}

template <class T>
Verdict judge_log(const void *const *inputs, const void *out, bool fuses, Given given)
{
    using R = Wide<T>;
    if (!usable_motor<T>(inputs[0]))
        return {};
    const Motor<R> motor = motor_of<R>(numbers<T>(inputs[0]));
    const auto judge = [&](const Motor<R> &right) {
        Verdict verdict = given == Given::unit ? Verdict() : of_any_length<T>();
        // The shortest logarithm of the motor with s >= 0; of the other one, with s = 0 or -0, its opposite.
        const Motor<R> b = log(right.r.w < 0 ? R(-1) * right : right, Way::principal);
        const bool unit = given == Given::unit;
        near_bivector(verdict, numbers<T>(out), b, length(b.r.v), unit ? 1.5 : 2,
                      unit ? length(b.d.v) : larger(length(b.d.v), reach(motor) / 2),
                      unit ? Bound(2.5, 3).of(fuses) : 4);
        return verdict;
    };
    return motor.r.w == 0 ? either_sign<T>(motor, judge) : judge(motor);
}

template <class T>
Verdict judge_log_principal(const void *const *inputs, const void *out, bool fuses, Given given)
{
    using R = Wide<T>;
    if (!usable_motor<T>(inputs[0]))
        return {};
    const Motor<R> motor = motor_of<R>(numbers<T>(inputs[0]));
    const R sine = length(motor.r.v) / length(motor.r);
    const auto judge = [&](Way way) {
        Verdict verdict = given == Given::unit ? Verdict() : of_any_length<T>();
        const Motor<R> b = log(motor, way);
        const bool unit = given == Given::unit, beyond = motor.r.w < 0 && way == Way::principal;
        // What is w depends on the moment by the sine, unless there is a pseudoscalar part in it.
        const R size = reach(motor) / 2, most = size / (sine * (unit ? R(1) : sine));
        // Before the terms cancel they are larger by another factor.
        const R terms = beyond ? R(4 * size / (sine * sine * sine)) : R(0);
        if (terms < largest<T>())
            near_bivector(verdict, numbers<T>(out), b, length(b.r.v), unit ? 3.5 : 4.5,
                          beyond ? most : larger(length(b.d.v), size),
                          (beyond ? Bound(11.5, 12.5) : Bound(3, 4)).of(fuses) + (unit ? 0 : 1));
        return verdict;
    };
    if (motor.r.w > 0 || sine > scaled(R(1), -39))
        return judge(Way::principal);
    return sine < scaled(R(1), -41) ? judge(Way::shortest)
                                    : Verdict::better(judge(Way::shortest), judge(Way::principal));
}

template <class T>
Function logarithm(Given given, Way way)
{
    const bool shortest = way == Way::shortest;
    Function f{"log",
               named<T>(shortest ? "log_motor_each" : "log_principal_motor_each"),
               {motors_of<T>()},
               {6, sizeof(T)},
               draw_motor<T>(given),
               {},
               {}};
    const unsigned flags = given == Given::unit ? MW_UNIT_MOTORS : MW_DEFAULT;
    if (given == Given::unit)
        f.name += " of unit motors";
    f.ways = {[=](const Call &call) {
        const auto function = shortest ? api<T>::log_motor_each : api<T>::log_principal_motor_each;
        return function(view_of<typename api<T>::bivectors>(call.out),
                        view_of<typename api<T>::const_motors>(call.in[0]), call.count, flags);
    }};
    f.judge = [=](const void *const *inputs, const void *out, bool fuses) {
        return shortest ? judge_log<T>(inputs, out, fuses, given) : judge_log_principal<T>(inputs, out, fuses, given);
    };
    return f;
}

// ------------------------------------------------------------------------------------------------- roots and powers

template <class T>
Verdict judge_power(const Motor<Wide<T>> &motor, Wide<T> t, const T *out, double rotation_bound,
                    double translation_bound)
{
    using R = Wide<T>;
    return either_sign<T>(motor, [&](const Motor<R> &near) {
        Verdict verdict;
        const Motor<R> b = log(near.r.w < 0 ? R(-1) * near : near, Way::principal);
        const Motor<R> right = exp(t * b);
        const R times = larger(R(1), abs(t));
        unit_motor(verdict, out);
        near_motor(verdict, out, right, times, rotation_bound,
                   t == R(0.5) ? length(right.d) : times * times * length(b.d.v), translation_bound);
        return verdict;
    });
}

template <class T>
Function square_root()
{
    Function f{"power", named<T>("sqrt_motor_each"), {motors_of<T>()}, motors_of<T>(), draw_motor<T>(Given::unit), {},
               {}};
    f.ways = {[](const Call &call) {
        return api<T>::sqrt_motor_each(view_of<typename api<T>::motors>(call.out),
                                       view_of<typename api<T>::const_motors>(call.in[0]), call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        if (!judgeable<T>(inputs[0], 8))
            return Verdict();
        const auto motor = motor_of<Wide<T>>(numbers<T>(inputs[0]));
        return judge_power<T>(motor, Wide<T>(0.5), numbers<T>(out), 1.5, 3);
    };
    return f;
}

template <class T>
Function power_of()
{
    Function f{"power", named<T>("power_motor_each"), {motors_of<T>(), {1, sizeof(T)}}, motors_of<T>(), {}, {}, {}};
    f.draw = [](Random &random, void *const *inputs) {
        Draw<T> draw(random);
        T *const exponent = static_cast<T *>(inputs[1]);
        draw_motor<T>(Given::unit)(random, inputs);
        *exponent = draw.chance(2)   ? static_cast<T>(draw.uniform(-8, 8))
                    : draw.chance(2) ? draw.angle()
                                     : draw.number();
        draw.spoil(exponent, 1);
    };
    f.ways = {[](const Call &call) {
        return api<T>::power_motor_each(view_of<typename api<T>::motors>(call.out),
                                        view_of<typename api<T>::const_motors>(call.in[0]), first_of<T>(call.in[1]),
                                        call.in[1].stride, call.count);
    }};
    f.judge = [](const void *const *inputs, const void *out, bool) {
        // An angle that is not finite is none.
        if (!judgeable<T>(inputs[0], 8) || !judgeable<T>(inputs[1], 1) ||
            abs(Wide<T>(*numbers<T>(inputs[1]))) * 4 > largest<T>())
            return Verdict();
        const auto motor = motor_of<Wide<T>>(numbers<T>(inputs[0]));
        return judge_power<T>(motor, Wide<T>(*numbers<T>(inputs[1])), numbers<T>(out), 3, 3);
    };
    return f;
}

template <class T>
void add(Functions &functions)
{
    functions.push_back(exponential<T>());
    for (const Given given : {Given::unit, Given::any})
        for (const Way way : {Way::shortest, Way::principal})
            functions.push_back(logarithm<T>(given, way));
    functions.push_back(square_root<T>());
    functions.push_back(power_of<T>());
}

}  // namespace

void add_exponentials(Functions &functions)
{
    add<float>(functions);
    add<double>(functions);
}

}  // namespace motorway::fuzz
