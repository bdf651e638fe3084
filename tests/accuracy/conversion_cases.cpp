// To another representation and back.
#include "cases.h"
#include "library.h"

namespace motorway::accuracy {
namespace {

// There and back; S and -S are the same motion.
template <class T>
Case<T> round_trip(const std::string &representation, const Angles &angles,
                   std::function<std::vector<T>(const std::vector<T> &)> there_and_back)
{
    Case<T> c;
    c.title = {"conversions", representation, angles.name, "1", "the one given"};
    c.input_sizes = {8};
    c.draw = [=](Random &random, T *const *inputs) {
        const double angle = angles.draw(random);
        const Quad sign = random.chance(2) ? -1 : 1;
        round_to(multiple(sign, draw_exact_motor(random, angle, usual_lengths)), inputs[0]);
        return angle;
    };
    c.set_truth([](auto number, const T *const *inputs) {
        using R = decltype(number);
        const auto motor = normalize(exactly<R, 8>(inputs[0]));
        return Truth<R>{motor, 1, length(motor, 4, 8), negated(motor)};
    });
    c.run = [=](const auto &inputs) { return there_and_back(inputs[0]); };
    return c;
}

template <class T>
struct Trips {
    using A = api<T>;
    using L = Library<T>;
    using Numbers = std::vector<T>;

    static Numbers pose(const Numbers &in)
    {
        const std::size_t count = in.size() / 8, four = sizeof(T[4]), three = sizeof(T[3]);
        Numbers turns(4 * count), offsets(3 * count), out(in.size());
        check(A::convert_motor_to_pose_each(A::xyzw_aos(turns.data(), four), A::xyz_aos(offsets.data(), three), L::motors(in), count));
        check(A::convert_pose_to_motor_each(L::motors(out), A::const_xyzw_aos(turns.data(), four), A::const_xyz_aos(offsets.data(), three),
                           count));
        return out;
    }

    static Numbers dual_quaternion(const Numbers &in)
    {
        const std::size_t count = in.size() / 8, stride = sizeof(T[8]);
        Numbers middle(in.size()), out(in.size());
        check(A::convert_motor_to_dual_quaternion_each(A::dual_quaternions_aos(middle.data(), stride), L::motors(in), count));
        check(A::convert_dual_quaternion_to_motor_each(L::motors(out), A::const_dual_quaternions_aos(middle.data(), stride), count));
        return out;
    }

    static Numbers matrix(const Numbers &in, unsigned flags)
    {
        const std::size_t count = in.size() / 8, stride = sizeof(T[12]);
        Numbers middle(12 * count), out(in.size());
        check(A::convert_motor_to_matrix_each({middle.data(), stride, MW_MATRIX_ROWS_3X4}, L::motors(in), count));
        check(A::convert_matrix_to_motor_each(L::motors(out), {middle.data(), stride, MW_MATRIX_ROWS_3X4}, count, flags, nullptr));
        return out;
    }

    static Numbers axis_angle(const Numbers &in)
    {
        const std::size_t count = in.size() / 8, four = sizeof(T[4]), three = sizeof(T[3]);
        Numbers turns(4 * count), offsets(3 * count), out(in.size());
        check(A::convert_motor_to_axis_angle_each(A::xyzw_aos(turns.data(), four), A::xyz_aos(offsets.data(), three), L::motors(in), count));
        check(A::convert_axis_angle_to_motor_each(L::motors(out), A::const_xyzw_aos(turns.data(), four),
                                 A::const_xyz_aos(offsets.data(), three), count));
        return out;
    }

    static Numbers euler(const Numbers &in, mw_euler_order order)
    {
        const std::size_t count = in.size() / 8, three = sizeof(T[3]);
        Numbers angles(3 * count), offsets(3 * count), out(in.size());
        check(A::convert_motor_to_euler_each(A::xyz_aos(angles.data(), three), A::xyz_aos(offsets.data(), three), L::motors(in), count, order));
        check(A::convert_euler_to_motor_each(L::motors(out), A::const_xyz_aos(angles.data(), three), A::const_xyz_aos(offsets.data(), three),
                            count, order));
        return out;
    }

    static Numbers screw(const Numbers &in)
    {
        const std::size_t count = in.size() / 8, stride = sizeof(T[8]);
        Numbers middle(in.size()), out(in.size());
        check(A::convert_motor_to_screw_each(A::screws_aos(middle.data(), stride), L::motors(in), count));
        check(A::convert_screw_to_motor_each(L::motors(out), A::const_screws_aos(middle.data(), stride), count));
        return out;
    }

    static Numbers rotor(const Numbers &in)
    {
        const T lambda = T(0.37);
        Numbers middle(in.size()), out(in.size());
        check(A::convert_motor_to_rotor_each(L::motors(middle), L::motors(in), in.size() / 8, lambda));
        check(A::convert_rotor_to_motor_each(L::motors(out), L::motors(static_cast<const Numbers &>(middle)), in.size() / 8, lambda));
        return out;
    }
};

struct Order {
    const char *name;
    mw_euler_order order;
};
constexpr Order orders[] = {
    {"xyz", MW_EULER_XYZ}, {"xzy", MW_EULER_XZY}, {"yxz", MW_EULER_YXZ}, {"yzx", MW_EULER_YZX},
    {"zxy", MW_EULER_ZXY}, {"zyx", MW_EULER_ZYX}, {"xyx", MW_EULER_XYX}, {"xzx", MW_EULER_XZX},
    {"yxy", MW_EULER_YXY}, {"yzy", MW_EULER_YZY}, {"zxz", MW_EULER_ZXZ}, {"zyz", MW_EULER_ZYZ}};

// The second angle at or near where the first and the third are about the same axis.
template <class T>
Case<T> gimbal_lock(const Order &of)
{
    Case<T> c = round_trip<T>(std::string("Euler angles ") + of.name, nothing,
                              [=](const std::vector<T> &in) { return Trips<T>::euler(in, of.order); });
    const bool same_axes = of.name[0] == of.name[2];
    c.title.inputs = "at and around gimbal lock";
    c.draw = [=](Random &random, T *const *inputs) {
        Motor<Quad> motor = draw_exact_motor(random, 0, usual_lengths);  // a translation
        for (int k = 0; k < 3; ++k) {  // the last angle acts first
            const double locked = (same_axes ? 0 : turn / 4) + (random.chance(4) ? 0 : random.magnitude(1e-10, 1e-2));
            const Quad half = k == 1 ? locked / 2 : random.uniform(-turn / 4, turn / 4);
            Bivector<Quad> B = {0, 0, 0, 0, 0, 0};
            switch (of.name[k]) {
            case 'x': B[2] = half; break;
            case 'y': B[1] = -half; break;
            default: B[0] = half; break;
            }
            motor = compose(exp(B), motor);
        }
        round_to(motor, inputs[0]);
        return 2 * std::acos(static_cast<double>(motor[0]));
    };
    return c;
}

}  // namespace

template <class T>
std::vector<Case<T>> conversion_cases()
{
    using Numbers = std::vector<T>;
    const auto matrix = [](unsigned flags) {
        return [=](const Numbers &in) { return Trips<T>::matrix(in, flags); };
    };
    std::vector<Case<T>> cases;
    for (const Angles &angles : {tiny_angles, to_a_turn, around_a_half_turn, around_a_turn}) {
        const auto add = [&](const char *name, auto function) {
            cases.push_back(round_trip<T>(name, angles, function));
        };
        add("quaternion and translation", Trips<T>::pose);
        add("dual quaternion", Trips<T>::dual_quaternion);
        add("matrix", matrix(MW_DEFAULT));
        add("matrix, nearest rotation", matrix(MW_NEAREST_ROTATION));
        add("axis and angle", Trips<T>::axis_angle);
        add("screw", Trips<T>::screw);
        add("rotor", Trips<T>::rotor);
    }
    for (const Order &of : orders) {
        const auto trip = [=](const Numbers &in) { return Trips<T>::euler(in, of.order); };
        cases.push_back(round_trip<T>(std::string("Euler angles ") + of.name, to_a_turn, trip));
        cases.push_back(gimbal_lock<T>(of));
    }
    return cases;
}

template std::vector<Case<float>> conversion_cases();
template std::vector<Case<double>> conversion_cases();

}  // namespace motorway::accuracy
